#pragma once
// Times of one cell in two runs.

#include "reports/analysis/cell_series.hpp"
#include "reports/analysis/comparison.hpp"

namespace alcove {

/// A cell's times and those of its round's anchor.
struct AnchoredCell {
    const CellSeries& cell;
    const CellSeries& anchor;
    /// Minimum detectable effect of the round; 0 if the anchor was not timed twice.
    double detectable = 0.0;
};

/// A cell with its round's anchor; empty series where there are no rows. `series` must outlive it.
[[nodiscard]] AnchoredCell find_anchored_cell(RoundSeries& series, const RoundRecord& round,
                                              const CellRecord& cell);

/// Everything but the verdict and the adjusted p-value; nothing if either has no ratio.
[[nodiscard]] std::optional<TimeComparison>
compare_times(const AnchoredCell& base, const AnchoredCell& next, const ComparisonOptions& options);

/// Adjusts the p-values of all times of a comparison and gives the verdicts: worse if the test
/// rejects at 5 % and the interval lies above 1 + margin, better likewise below 1 / (1 + margin),
/// same if the interval lies between the two. Where the tests by ranks are silent, better and worse
/// become unknown. A time without interval stays unknown.
void judge_times(const std::vector<TimeComparison*>& times);

/// A pass, an "input/..." or kConvergedPart of one cell, in units of its anchor.
struct PartShare {
    std::string part;
    bool is_cached = false; ///< an input cost stored with a reused G-buffer
    Estimate share;
};
inline constexpr std::string_view kConvergedPart = "converged";
[[nodiscard]] std::vector<PartShare> estimate_parts(const AnchoredCell& cell);

[[nodiscard]] std::vector<PartComparison> compare_parts(const AnchoredCell& base,
                                                        const AnchoredCell& next, bool paired);

} // namespace alcove
