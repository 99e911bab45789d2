#include "reports/papers/start_reproduction.hpp"

#include "reports/papers/claim.hpp"

namespace alcove {

Reproduction start_reproduction(const std::string& paper, const std::string& citation,
                                const Evidence& evidence, const std::string& scale,
                                const Judge& judge) {
    Reproduction reproduction;
    reproduction.paper = paper;
    reproduction.citation = citation;
    reproduction.scale = scale;
    reproduction.context = evidence.context();
    reproduction.verdicts = judge.finish(load_claims(paper));
    reproduction.errata = load_errata(paper);
    return reproduction;
}

} // namespace alcove
