#include "reports/analysis/sequences.hpp"

#include "reports/analysis/metric_table.hpp"

namespace alcove {
namespace {

/// Rows of one metric of one cell, by where they stand.
struct SequenceRows {
    std::vector<const MetricRow*> bursts;  ///< cold
    std::vector<const MetricRow*> singles; ///< converged
};

SequenceRows collect_rows(const RoundRecord& round, const std::vector<MetricRow>& rows,
                          const std::string& cell, const std::string& metric) {
    SequenceRows collected;
    for (const MetricRow& row : rows) {
        if (row.cell != cell || row.metric != metric) {
            continue;
        }
        const bool is_single = round.segments[static_cast<std::size_t>(row.segment)].is_single();
        if (row.state == SampleState::cold && !is_single) {
            collected.bursts.push_back(&row);
        } else if (row.state == SampleState::converged && is_single) {
            collected.singles.push_back(&row);
        }
    }
    return collected;
}

void add_frame_errors(CellAnalysis& cell, const std::vector<const MetricRow*>& rows) {
    for (const MetricRow* row : rows) {
        cell.frame_errors.push_back(make_frame_error(*row));
    }
}

} // namespace

void analyze_sequences(RoundAnalysis& round, const std::vector<MetricRow>& rows,
                       const PlanRecord& plan) {
    round.temporal_metrics = list_measured(rows, plan, "temporal");
    round.history_numbers = list_measured(rows, plan, "history");
    for (CellAnalysis& cell : round.cells) {
        for (const std::string& metric : round.temporal_metrics) {
            const SequenceRows found = collect_rows(round.round, rows, cell.cell.id, metric);
            cell.temporal.push_back(
                summarize_metric(metric, found.bursts, is_lower_better(plan, metric)));
            add_frame_errors(cell, found.bursts);
        }
        for (const std::string& number : round.history_numbers) {
            const SequenceRows found = collect_rows(round.round, rows, cell.cell.id, number);
            const bool lower = is_lower_better(plan, number);
            cell.history_cold.push_back(summarize_metric(number, found.bursts, lower));
            cell.history_converged.push_back(summarize_metric(number, found.singles, lower));
            add_frame_errors(cell, found.bursts);
        }
    }
}

} // namespace alcove
