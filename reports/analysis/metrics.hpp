#pragma once
// Image errors of one round: which frames stand in which column, and their means.

#include "reports/analysis/analysis.hpp"

#include <vector>

namespace alcove {

/// Fills metrics, front_metric, floors and every cell's error tables from the round's rows.
/// Cold: bursts (all segments if there is no burst). Converged: singles; a cell that is not warmed
/// up has its cold singles there.
void analyze_metrics(RoundAnalysis& round, const std::vector<MetricRow>& rows,
                     const PlanRecord& plan);

/// Marks the cells that no other method beats in both the ratio and front_metric. Errors under the
/// floor count as the floor; a cell without passes has ratio 0.
void mark_front(RoundAnalysis& round, const PlanRecord& plan);

} // namespace alcove
