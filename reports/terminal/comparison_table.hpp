#pragma once
// The table that `alcove compare` and `alcove ab` end with, as plain text.

#include "reports/analysis/comparison.hpp"

#include <string>

namespace alcove {

/// Every time and every metric that did not stay the same, then images, settings and what has no
/// partner. No control characters, also not out of labels. Ends with a line end.
[[nodiscard]] std::string make_comparison_table(const Comparison& comparison);

} // namespace alcove
