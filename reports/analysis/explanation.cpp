#include "reports/analysis/explanation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace alcove {
namespace {

constexpr std::array kMoments{
    &StepRecord::total, &StepRecord::d1,          &StepRecord::d2,
    &StepRecord::d3,    &StepRecord::d1_d2,       &StepRecord::d1_d3,
    &StepRecord::d2_d3, &StepRecord::truth_noise, &StepRecord::march_noise};

} // namespace

std::vector<ExplainedError> explain_errors(const RoundAnalysis& round) {
    std::vector<ExplainedError> explained;
    for (const CellAnalysis& cell : round.cells) {
        const std::size_t first = explained.size();
        for (const StepRecord& steps : round.done.steps) {
            if (steps.cell != cell.cell.id) {
                continue;
            }
            auto entry = std::find_if(
                explained.begin() + static_cast<std::ptrdiff_t>(first), explained.end(),
                [&](const ExplainedError& e) { return e.thickness == steps.thickness; });
            if (entry == explained.end()) {
                explained.push_back({cell.cell.id, cell.cell.label, steps.thickness, 0, {}, 0.0});
                entry = explained.end() - 1;
                entry->mean.has_converged_form = steps.has_converged_form;
            }
            ++entry->frames;
            for (double StepRecord::*moment : kMoments) {
                entry->mean.*moment += steps.*moment;
            }
        }
    }
    for (ExplainedError& entry : explained) {
        StepRecord& mean = entry.mean;
        for (double StepRecord::*moment : kMoments) {
            mean.*moment /= static_cast<double>(entry.frames);
        }
        entry.closure = mean.total - (mean.d1 + mean.d2 + mean.d3 +
                                      2.0 * (mean.d1_d2 + mean.d1_d3 + mean.d2_d3));
    }
    return explained;
}

std::vector<CurveAnalysis> analyze_curves(const RoundAnalysis& round) {
    std::vector<CurveAnalysis> curves;
    for (const CurveRecord& curve : round.done.curves) {
        const auto cell =
            std::find_if(round.cells.begin(), round.cells.end(),
                         [&](const CellAnalysis& c) { return c.cell.id == curve.cell; });
        if (cell == round.cells.end()) {
            continue;
        }
        CurveAnalysis analysis{cell->cell.label, curve, std::sqrt(curve.mse),
                               std::sqrt(curve.mse_fitted), std::nullopt};
        if (std::isfinite(curve.mse_held_out)) {
            analysis.rmse_held_out = std::sqrt(curve.mse_held_out);
        }
        curves.push_back(std::move(analysis));
    }
    return curves;
}

} // namespace alcove
