#pragma once
// What a reader needs to judge the numbers: what is still running or left out, the machine, the
// definitions.

#include "reports/analysis/analysis.hpp"

#include <string>

namespace alcove {

/// Rounds that are not finished, with their provisional times; empty if there are none.
[[nodiscard]] std::string make_unfinished_section(const RunAnalysis& analysis);
/// Scenes that did not run, with the reason; empty if there are none.
[[nodiscard]] std::string make_skipped_section(const RunAnalysis& analysis);
/// Build, device and the trials of the timers.
[[nodiscard]] std::string make_environment_section(const RunAnalysis& analysis);
/// Every number and metric, methods with citations, scenes with licences.
[[nodiscard]] std::string make_definitions_section(const RunAnalysis& analysis);

} // namespace alcove
