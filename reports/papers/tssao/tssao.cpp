#include "reports/papers/tssao/tssao.hpp"

#include "reports/papers/start_reproduction.hpp"
#include "reports/papers/tssao/tssao_parts.hpp"

namespace alcove {

Reproduction reproduce_tssao(const Evidence& evidence, const std::string& scale) {
    Judge judge;
    judge_tssao_times(evidence, judge);
    judge_tssao_states(evidence, judge);
    judge_tssao_quality(evidence, judge);
    list_tssao_untestable(judge);
    Reproduction reproduction =
        start_reproduction("TSSAO",
                           "Mattausch, Scherzer, Wimmer. High-quality screen-space ambient "
                           "occlusion using temporal coherence. 2010.",
                           evidence, scale, judge);
    reproduction.tables = make_tssao_tables(evidence);
    reproduction.figures = make_tssao_figures(evidence);
    return reproduction;
}

} // namespace alcove
