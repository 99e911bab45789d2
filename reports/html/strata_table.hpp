#pragma once
// Where in the frames errors lie: a table a metric, strata across, methods down.

#include "reports/analysis/analysis.hpp"

#include <string>

namespace alcove {

/// Empty where the round has no strata.
[[nodiscard]] std::string make_strata_tables(const RunAnalysis& analysis,
                                             const RoundAnalysis& round);

} // namespace alcove
