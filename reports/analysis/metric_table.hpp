#pragma once
// What tables of all kinds of metrics share: which metrics a round has, and their means.

#include "reports/analysis/analysis.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// Metrics of a kind (MetricDescription::kind) that have rows, in the plan's order. Those that the
/// plan does not describe count as image metrics and stand last.
[[nodiscard]] std::vector<std::string> list_measured(const std::vector<MetricRow>& rows,
                                                     const PlanRecord& plan, std::string_view kind);

[[nodiscard]] bool is_lower_better(const PlanRecord& plan, const std::string& metric);

/// Does a row of an image metric stand in its cell's cold column: bursts (all segments if there is
/// no burst)?
[[nodiscard]] bool stands_in_cold(const RoundRecord& round, const MetricRow& row);
/// ... in its converged column: singles. A cell that is not warmed up has its cold singles there.
[[nodiscard]] bool stands_in_converged(const RoundRecord& round, const CellRecord& cell,
                                       const MetricRow& row);

/// Means over rows of one metric and cell.
[[nodiscard]] MetricAnalysis summarize_metric(const std::string& metric,
                                              const std::vector<const MetricRow*>& rows,
                                              bool lower_is_better);

/// One row as a point of a curve.
[[nodiscard]] FrameError make_frame_error(const MetricRow& row);

} // namespace alcove
