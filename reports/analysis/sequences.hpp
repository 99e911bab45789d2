#pragma once
// Metrics over time and numbers of histories of one round: which frames stand in their means.

#include "reports/analysis/analysis.hpp"

#include <vector>

namespace alcove {

/// Fills temporal_metrics, history_numbers and every cell's tables of both, and adds their values
/// to frame_errors. A metric over time belongs to bursts: rows of a segment that is none are left
/// out. Numbers of histories: bursts cold, singles converged.
void analyze_sequences(RoundAnalysis& round, const std::vector<MetricRow>& rows,
                       const PlanRecord& plan);

} // namespace alcove
