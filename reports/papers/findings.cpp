#include "reports/papers/findings.hpp"

#include "core/base/assert.hpp"

namespace alcove {

Finding compare_metrics(const Evidence& evidence, const CellAddress& a, const CellAddress& b,
                        const std::string& metric, SampleState state, const std::string& on) {
    const Estimate difference = evidence.compare_metric(a, b, metric, state);
    return {judge_below(difference, 0.0), metric + " of " + a.label + " - of " + b.label + " < 0",
            difference, on};
}

Finding combine_findings(const std::vector<Finding>& findings, const std::string& tested) {
    ALCOVE_ASSERT(!findings.empty(), "something to combine");
    std::vector<Outcome> outcomes;
    for (const Finding& finding : findings) {
        outcomes.push_back(finding.outcome);
    }
    const Outcome outcome = combine(outcomes);
    for (const Finding& finding : findings) {
        if (finding.outcome == outcome) {
            return {outcome, tested, finding.measured, finding.tested + "; " + finding.why};
        }
    }
    return findings.front();
}

std::string describe_round(const Evidence& evidence, const std::string& part, std::size_t round) {
    const RoundRecord& record = evidence.get_round(part, round);
    return std::to_string(record.segments.size()) + " views of " + record.scene + " at " +
           std::to_string(record.width) + "x" + std::to_string(record.height);
}

FigurePicture make_cell_picture(const Evidence& evidence, const CellAddress& cell, int frame,
                                const std::string& picture, const std::string& caption) {
    const std::string path = RunFolder::make_image_path(
        evidence.get_round(cell.part, cell.round).id, evidence.get_cell(cell).id, frame, picture);
    return {caption, "parts/" + cell.part + "/" + path};
}

} // namespace alcove
