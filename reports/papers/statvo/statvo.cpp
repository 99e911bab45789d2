#include "reports/papers/statvo/statvo.hpp"

#include "reports/papers/claim.hpp"
#include "reports/papers/statvo/statvo_parts.hpp"

namespace alcove {

Reproduction reproduce_statvo(const Evidence& evidence, const std::string& scale) {
    Judge judge;
    judge_statvo_times(evidence, judge);
    judge_statvo_rivals(evidence, judge);
    judge_statvo_quality(evidence, judge);
    list_statvo_untestable(judge);
    Reproduction reproduction;
    reproduction.paper = "STATVO";
    reproduction.citation = "Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered "
                            "statistical volumetric obscurance. 2015.";
    reproduction.scale = scale;
    reproduction.context = evidence.context();
    reproduction.verdicts = judge.finish(load_claims("STATVO"));
    reproduction.tables = make_statvo_tables(evidence);
    reproduction.figures = make_statvo_figures(evidence);
    reproduction.errata = load_errata("STATVO");
    return reproduction;
}

} // namespace alcove
