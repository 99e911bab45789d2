#pragma once
// Errors by target and settings: common, calibrated and native tables, and the ranking over
// targets.

#include "reports/analysis/analysis.hpp"

#include <string>

namespace alcove {

/// Empty where the run has one target and common settings alone.
[[nodiscard]] std::string make_target_section(const RunAnalysis& analysis);

} // namespace alcove
