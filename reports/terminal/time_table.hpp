#pragma once
// The second table of a round: how methods behave over time.

#include "reports/analysis/analysis.hpp"

#include <string>

namespace alcove {

/// Columns that have a value, with a line that says what they mean; empty if no method was followed
/// over time.
[[nodiscard]] std::string make_time_table(const RoundAnalysis& round);

} // namespace alcove
