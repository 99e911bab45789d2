#pragma once
// Errors in steps (DESIGN 3.7) and what a curve would mend, as means over a round's single frames.

#include "reports/analysis/analysis.hpp"

namespace alcove {

/// One cell over one march.
struct ExplainedError {
    std::string cell;
    std::string label;
    double thickness = 0.0; ///< of the march, in radii; may be infinite
    std::size_t frames = 0;
    StepRecord mean; ///< moments and noises alone
    /// total - (d1 + d2 + d3 + 2 (d1 d2 + d1 d3 + d2 d3)): rounding, since the sum closes by
    /// construction.
    double closure = 0.0;
};

/// In the order of cells, for each the infinite march first. Empty where the round was not
/// explained.
[[nodiscard]] std::vector<ExplainedError> explain_errors(const RoundAnalysis& round);

struct CurveAnalysis {
    std::string label;
    CurveRecord curve;
    double rmse = 0.0;
    double rmse_fitted = 0.0;
    std::optional<double> rmse_held_out; ///< nothing for a single frame
};
[[nodiscard]] std::vector<CurveAnalysis> analyze_curves(const RoundAnalysis& round);

} // namespace alcove
