#pragma once
// Estimates that judgements of several papers are made of.

#include "core/base/statistics.hpp"
#include "reports/papers/verdict.hpp"

#include <map>
#include <vector>

namespace alcove {

/// Of one value that is no sample: n = 1, no interval.
[[nodiscard]] Estimate make_single(double value);
/// Value, extremes and interval times `factor` > 0.
[[nodiscard]] Estimate scale_estimate(Estimate estimate, double factor);
/// Pearson's r of two series of equal length, at least 4, with Fisher's 95 % interval.
[[nodiscard]] Estimate correlate(const std::vector<double>& a, const std::vector<double>& b);
/// r^2 of a straight line through (x, time), repeat by repeat: `times` holds a series by repeat for
/// each x, 4 or more.
[[nodiscard]] Estimate estimate_linearity(const std::vector<double>& x,
                                          const std::vector<std::map<int, double>>& times);
/// Is `higher`'s interval above `lower`'s, or at least not under it by more than `slack`?
[[nodiscard]] Outcome judge_order(const Estimate& higher, const Estimate& lower, double slack);

} // namespace alcove
