#pragma once
// comparison.md: a comparison as a comment under a pull request.

#include "reports/analysis/comparison.hpp"

#include <string>

namespace alcove {

/// The verdicts in one line, a table of what did not stay the same, the rest folded away.
[[nodiscard]] std::string make_comparison_markdown(const Comparison& comparison);

} // namespace alcove
