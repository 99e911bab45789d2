#include "reports/papers/statvo/statvo.hpp"

#include "reports/papers/findings.hpp"
#include "reports/papers/start_reproduction.hpp"
#include "reports/papers/statvo/statvo_parts.hpp"

namespace alcove {

std::string describe_views(const Evidence& evidence, const std::string& part, std::size_t round) {
    const RoundRecord& record = evidence.get_round(part, round);
    constexpr int kPublishedHeight = 720;
    std::string text = describe_round(evidence, part, round);
    if (record.height < kPublishedHeight && part != "resolution") {
        text +=
            "; a box has fewer pixels than as published, so that downsampled tables are coarser "
            "in it, and passes are short beside their start";
    }
    return text;
}

Reproduction reproduce_statvo(const Evidence& evidence, const std::string& scale) {
    Judge judge;
    judge_statvo_times(evidence, judge);
    judge_statvo_rivals(evidence, judge);
    judge_statvo_quality(evidence, judge);
    list_statvo_untestable(judge);
    Reproduction reproduction =
        start_reproduction("STATVO",
                           "Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered "
                           "statistical volumetric obscurance. 2015.",
                           evidence, scale, judge);
    reproduction.tables = make_statvo_tables(evidence);
    reproduction.figures = make_statvo_figures(evidence);
    return reproduction;
}

} // namespace alcove
