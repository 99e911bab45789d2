#pragma once
// Time against accuracy, over all cells of a scene and target: readable without JavaScript.

#include "reports/analysis/analysis.hpp"

#include <string>

namespace alcove {

/// One folding table a scene and target, closed where it is long; empty if the run has no
/// trade-off.
[[nodiscard]] std::string make_tradeoff_section(const RunAnalysis& analysis);

} // namespace alcove
