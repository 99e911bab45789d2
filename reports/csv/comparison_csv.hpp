#pragma once
// comparison.csv: one line a verdict and a piece of information. Columns: reports/README.md.

#include "reports/analysis/comparison.hpp"

#include <string>

namespace alcove {

[[nodiscard]] std::string make_comparison_csv(const Comparison& comparison);

} // namespace alcove
