#include "reports/analysis/stability_wording.hpp"

#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {

std::string format_margin(double margin) {
    return std::isfinite(margin) ? format_rounded(margin, 2) : "x";
}

std::string describe_outcome(const StabilityCaseRecord& described,
                             const StabilityCellRecord& cell) {
    const std::string margin = format_margin(cell.worst_margin);
    switch (cell.outcome) {
    case StabilityOutcome::holds:
        return "holds " + margin;
    case StabilityOutcome::holds_up_to:
        return "to " + described.severities[judge(cell.scores).held - 1].label + " " + margin;
    case StabilityOutcome::fails:
        return "fails " + margin;
    case StabilityOutcome::not_applicable:
        break;
    }
    return "n/a";
}

std::string summarize_stability(const StabilityRecord& record) {
    std::size_t applicable = 0;
    for (const StabilityCellRecord& cell : record.cells) {
        applicable += cell.outcome == StabilityOutcome::not_applicable ? 0 : 1;
    }
    std::size_t sound = 0;
    for (const StabilityMethodRecord& method : record.methods) {
        sound += std::all_of(record.cells.begin(), record.cells.end(),
                             [&](const StabilityCellRecord& cell) {
                                 return cell.label != method.label ||
                                        cell.outcome == StabilityOutcome::holds ||
                                        cell.outcome == StabilityOutcome::not_applicable;
                             })
                     ? 1
                     : 0;
    }
    return std::to_string(sound) + " of " + std::to_string(record.methods.size()) +
           " methods hold in every case that applies to them; " +
           std::to_string(count_failures(record)) + " of " + std::to_string(applicable) +
           " combinations fail";
}

} // namespace alcove
