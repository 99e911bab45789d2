#pragma once
// The many comparisons of two runs taken together.

#include "reports/analysis/comparison.hpp"

namespace alcove {

/// Adjusts the p-values of all times and metrics together (Benjamini and Hochberg).
void find_discoveries(Comparison& comparison);

} // namespace alcove
