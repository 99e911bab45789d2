#include "reports/analysis/metrics.hpp"

#include "core/base/statistics.hpp"

#include <algorithm>

namespace alcove {
namespace {

bool is_lower_better(const PlanRecord& plan, const std::string& metric) {
    const auto found = std::find_if(plan.metrics.begin(), plan.metrics.end(),
                                    [&](const MetricDescription& m) { return m.name == metric; });
    return found == plan.metrics.end() || found->lower_is_better;
}

std::optional<double> mean_of_all(const std::vector<std::optional<double>>& values) {
    std::vector<double> present;
    for (const std::optional<double>& value : values) {
        if (!value) {
            return std::nullopt;
        }
        present.push_back(*value);
    }
    return present.empty() ? std::nullopt : std::optional<double>(compute_mean(present));
}

MetricAnalysis summarize(const std::string& metric, const std::vector<const MetricRow*>& rows,
                         bool lower_is_better) {
    MetricAnalysis result;
    result.metric = metric;
    std::vector<double> values;
    std::vector<std::optional<double>> debiased;
    std::vector<std::optional<double>> floors;
    for (const MetricRow* row : rows) {
        if (!row->value) {
            ++result.undefined;
            result.note = result.note.empty() ? row->note : result.note;
            continue;
        }
        values.push_back(*row->value);
        debiased.push_back(row->debiased);
        floors.push_back(row->floor);
    }
    result.frames = values.size();
    if (values.empty()) {
        return result;
    }
    result.value = compute_mean(values);
    result.minimum = *std::min_element(values.begin(), values.end());
    result.maximum = *std::max_element(values.begin(), values.end());
    result.debiased = mean_of_all(debiased);
    result.floor = mean_of_all(floors);
    if (result.floor) {
        result.is_below_floor =
            lower_is_better ? result.shown() < *result.floor : result.shown() > *result.floor;
    }
    return result;
}

/// Metrics with rows: the plan's order first, then those it does not describe.
std::vector<std::string> list_metrics(const std::vector<MetricRow>& rows, const PlanRecord& plan) {
    std::vector<std::string> measured;
    for (const MetricRow& row : rows) {
        if (std::find(measured.begin(), measured.end(), row.metric) == measured.end()) {
            measured.push_back(row.metric);
        }
    }
    const auto rank = [&](const std::string& name) {
        return std::find_if(plan.metrics.begin(), plan.metrics.end(),
                            [&](const MetricDescription& m) { return m.name == name; }) -
               plan.metrics.begin();
    };
    std::stable_sort(measured.begin(), measured.end(),
                     [&](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
    return measured;
}

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
    round.metrics = list_metrics(rows, plan);
    const auto is_single = [&](int segment) {
        return round.round.segments[static_cast<std::size_t>(segment)].is_single();
    };
    const bool has_bursts = std::any_of(round.round.segments.begin(), round.round.segments.end(),
                                        [](const SegmentRecord& s) { return !s.is_single(); });
    for (CellAnalysis& cell : round.cells) {
        const SampleState held =
            cell.cell.warm_frames > 0 ? SampleState::converged : SampleState::cold;
        for (const std::string& metric : round.metrics) {
            std::vector<const MetricRow*> cold;
            std::vector<const MetricRow*> converged;
            for (const MetricRow& row : rows) {
                if (row.cell != cell.cell.id || row.metric != metric) {
                    continue;
                }
                if (row.state == SampleState::cold) {
                    cell.frame_errors.push_back({row.segment, row.frame, metric,
                                                 row.debiased ? row.debiased : row.value,
                                                 row.floor});
                }
                if (row.state == SampleState::cold && (!has_bursts || !is_single(row.segment))) {
                    cold.push_back(&row);
                }
                if (row.state == held && is_single(row.segment)) {
                    converged.push_back(&row);
                }
            }
            const bool lower = is_lower_better(plan, metric);
            cell.cold.push_back(summarize(metric, cold, lower));
            cell.converged.push_back(summarize(metric, converged, lower));
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
        if (cell.cell.role == CellRole::method && error != nullptr && is_timed) {
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
