#include "reports/analysis/metric_table.hpp"

#include "core/base/statistics.hpp"

#include <algorithm>
#include <map>

namespace alcove {
namespace {

const MetricDescription* find_description(const PlanRecord& plan, const std::string& metric) {
    const auto found = std::find_if(plan.metrics.begin(), plan.metrics.end(),
                                    [&](const MetricDescription& m) { return m.name == metric; });
    return found == plan.metrics.end() ? nullptr : &*found;
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

bool is_single(const RoundRecord& round, int segment) {
    return round.segments[static_cast<std::size_t>(segment)].is_single();
}

/// Means of segments where there are enough of them for an interval, else frames.
Estimate estimate_over_content(const std::map<int, std::vector<double>>& by_segment) {
    std::vector<double> units;
    for (const auto& [segment, values] : by_segment) {
        if (by_segment.size() >= kMinimumRepeatsForInterval) {
            units.push_back(compute_mean(values));
        } else {
            units.insert(units.end(), values.begin(), values.end());
        }
    }
    return estimate_across_repeats(units);
}

} // namespace

bool stands_in_cold(const RoundRecord& round, const MetricRow& row) {
    const bool has_bursts = std::any_of(round.segments.begin(), round.segments.end(),
                                        [](const SegmentRecord& s) { return !s.is_single(); });
    return row.state == SampleState::cold && (!has_bursts || !is_single(round, row.segment));
}

bool stands_in_converged(const RoundRecord& round, const CellRecord& cell, const MetricRow& row) {
    const SampleState held = cell.warm_frames > 0 ? SampleState::converged : SampleState::cold;
    return row.state == held && is_single(round, row.segment);
}

bool is_lower_better(const PlanRecord& plan, const std::string& metric) {
    const MetricDescription* description = find_description(plan, metric);
    return description == nullptr || description->lower_is_better;
}

MetricAnalysis summarize_metric(const std::string& metric,
                                const std::vector<const MetricRow*>& rows, bool lower_is_better) {
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
    std::map<int, std::vector<double>> shown;
    for (const MetricRow* row : rows) {
        if (row->value) {
            shown[row->segment].push_back(result.debiased ? *row->debiased : *row->value);
        }
    }
    result.content = estimate_over_content(shown);
    if (result.floor) {
        result.is_below_floor =
            lower_is_better ? result.shown() < *result.floor : result.shown() > *result.floor;
    }
    return result;
}

std::vector<std::string> list_measured(const std::vector<MetricRow>& rows, const PlanRecord& plan,
                                       std::string_view kind) {
    std::vector<std::string> measured;
    for (const MetricRow& row : rows) {
        const MetricDescription* description = find_description(plan, row.metric);
        const std::string_view row_kind = description == nullptr
                                              ? std::string_view("image")
                                              : std::string_view(description->kind);
        if (row_kind == kind &&
            std::find(measured.begin(), measured.end(), row.metric) == measured.end()) {
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

FrameError make_frame_error(const MetricRow& row) {
    return {row.segment, row.frame, row.metric, row.debiased ? row.debiased : row.value, row.floor};
}

} // namespace alcove
