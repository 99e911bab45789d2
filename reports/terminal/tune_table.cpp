#include "reports/terminal/tune_table.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/terminal/text_table.hpp"

#include <fmt/core.h>

namespace alcove {

std::string make_tune_table(const TuneRecord& record) {
    TextLines lines{{"method", "frames", "metric", "before", "after", "change", "gap"}};
    std::string chosen;
    for (const TunedMethodRecord& method : record.methods) {
        for (const TuneJudgementRecord& judgement : method.judgements) {
            const std::optional<double> gap = find_generalisation_gap(method, judgement);
            lines.push_back(
                {clean_text(method.label), clean_text(judgement.set),
                 clean_text(judgement.metric) + (judgement.is_objective ? " (tuned on)" : ""),
                 format_rounded(judgement.before), format_rounded(judgement.after),
                 fmt::format("{} [{}, {}] (n={})", format_rounded(judgement.change),
                             format_rounded(judgement.lower), format_rounded(judgement.upper),
                             judgement.frames),
                 gap ? format_percent(*gap) : "-"});
        }
        chosen += "  " + clean_text(method.label) + ": ";
        for (const TuneParameterRecord& parameter : method.parameters) {
            chosen += clean_text(parameter.name) + " = " + clean_text(parameter.tuned) + "; ";
        }
        chosen += method.is_converged ? "converged" : "NOT CONVERGED";
        chosen += " (attempts end at";
        for (const double cost : method.least_costs) {
            chosen += " " + format_rounded(cost, 4);
        }
        chosen += "); " + clean_text(method.calibration) + "\n";
    }
    return align_columns(lines) + chosen +
           "change: mean over frames with its 95 % interval over frames; gap: share of the gain on "
           "training frames that is lost here\n";
}

} // namespace alcove
