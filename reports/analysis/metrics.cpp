#include "reports/analysis/metrics.hpp"

#include "core/base/statistics.hpp"
#include "reports/analysis/metric_table.hpp"

#include <algorithm>

namespace alcove {
namespace {

void summarize_floor(RoundAnalysis& round, bool lower_is_better) {
    std::vector<double> floors;
    for (const CellAnalysis& cell : round.cells) {
        const MetricAnalysis* error = cell.find(SampleState::cold, round.front_metric);
        if (error == nullptr || cell.cell.role != CellRole::method) {
            continue;
        }
        if (error->floor) {
            floors.push_back(*error->floor);
        }
        if (lower_is_better) {
            round.smallest_error =
                std::min(round.smallest_error.value_or(error->shown()), error->shown());
        }
    }
    if (!floors.empty()) {
        round.reference_floor = compute_mean(floors);
    }
}

} // namespace

void analyze_metrics(RoundAnalysis& round, const std::vector<MetricRow>& rows,
                     const PlanRecord& plan) {
    round.metrics = list_measured(rows, plan, "image");
    for (CellAnalysis& cell : round.cells) {
        for (const std::string& metric : round.metrics) {
            std::vector<const MetricRow*> cold;
            std::vector<const MetricRow*> converged;
            for (const MetricRow& row : rows) {
                if (row.cell != cell.cell.id || row.metric != metric) {
                    continue;
                }
                if (row.state == SampleState::cold) {
                    cell.frame_errors.push_back(make_frame_error(row));
                }
                if (stands_in_cold(round.round, row)) {
                    cold.push_back(&row);
                }
                if (stands_in_converged(round.round, cell.cell, row)) {
                    converged.push_back(&row);
                }
            }
            const bool lower = is_lower_better(plan, metric);
            cell.cold.push_back(summarize_metric(metric, cold, lower));
            cell.converged.push_back(summarize_metric(metric, converged, lower));
        }
    }
    if (!round.metrics.empty()) {
        const auto rmse = std::find(round.metrics.begin(), round.metrics.end(), "rmse");
        round.front_metric = rmse == round.metrics.end() ? round.metrics.front() : *rmse;
        summarize_floor(round, is_lower_better(plan, round.front_metric));
    }
}

void mark_front(RoundAnalysis& round, const PlanRecord& plan) {
    struct Point {
        CellAnalysis* cell;
        double ratio;
        double error;
    };
    const double sign = is_lower_better(plan, round.front_metric) ? 1.0 : -1.0;
    std::vector<Point> points;
    for (CellAnalysis& cell : round.cells) {
        const MetricAnalysis* error = cell.find(SampleState::cold, round.front_metric);
        const bool is_timed = cell.ratio || !cell.cell.has_passes;
        if (is_compared(cell) && error != nullptr && is_timed) {
            const double value = error->is_below_floor ? *error->floor : error->shown();
            points.push_back({&cell, cell.ratio ? cell.ratio->value : 0.0, sign * value});
        }
    }
    for (const Point& point : points) {
        point.cell->is_on_front =
            std::none_of(points.begin(), points.end(), [&](const Point& other) {
                return other.ratio <= point.ratio && other.error <= point.error &&
                       (other.ratio < point.ratio || other.error < point.error);
            });
    }
}

} // namespace alcove
