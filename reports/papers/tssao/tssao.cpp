#include "reports/papers/tssao/tssao.hpp"

#include "reports/papers/claim.hpp"
#include "reports/papers/tssao/tssao_parts.hpp"

namespace alcove {

Reproduction reproduce_tssao(const Evidence& evidence, const std::string& scale) {
    Judge judge;
    judge_tssao_times(evidence, judge);
    judge_tssao_states(evidence, judge);
    judge_tssao_quality(evidence, judge);
    list_tssao_untestable(judge);
    Reproduction reproduction;
    reproduction.paper = "TSSAO";
    reproduction.citation = "Mattausch, Scherzer, Wimmer. High-quality screen-space ambient "
                            "occlusion using temporal coherence. 2010.";
    reproduction.scale = scale;
    reproduction.context = evidence.context();
    reproduction.verdicts = judge.finish(load_claims("TSSAO"));
    reproduction.tables = make_tssao_tables(evidence);
    reproduction.figures = make_tssao_figures(evidence);
    reproduction.errata = load_errata("TSSAO");
    return reproduction;
}

} // namespace alcove
