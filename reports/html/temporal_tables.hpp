#pragma once
// Tables of how methods behave over time.

#include "reports/analysis/analysis.hpp"

#include <string>

namespace alcove {

/// Metrics over time, a column each; empty if there are none.
[[nodiscard]] std::string make_temporal_table(const RunAnalysis& analysis,
                                              const RoundAnalysis& round);
/// What methods with a history say of it, cold and converged; empty if there is none.
[[nodiscard]] std::string make_history_table(const RunAnalysis& analysis,
                                             const RoundAnalysis& round);
/// Times of methods with a history, cold against converged; empty if there is none.
[[nodiscard]] std::string make_convergence_table(const RunAnalysis& analysis,
                                                 const RoundAnalysis& round);

} // namespace alcove
