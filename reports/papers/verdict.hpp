#pragma once
// How a claim is judged: by the interval of what was measured, not by its middle.

#include "reports/analysis/reproduction.hpp"

#include <vector>

namespace alcove {

/// Holds if the whole interval lies above (below) the bound, fails if it lies on the other side.
/// Without an interval (fewer than 5 units) the extremes stand for it.
[[nodiscard]] Outcome judge_above(const Estimate& measured, double bound);
[[nodiscard]] Outcome judge_below(const Estimate& measured, double bound);
/// Holds if the interval lies within, fails if it lies outside.
[[nodiscard]] Outcome judge_within(const Estimate& measured, double lower, double upper);
/// Holds only if all hold; fails if one fails.
[[nodiscard]] Outcome combine(const std::vector<Outcome>& outcomes);

} // namespace alcove
