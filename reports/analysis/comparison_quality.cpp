#include "reports/analysis/comparison_quality.hpp"

#include "core/base/hypothesis.hpp"
#include "reports/analysis/metric_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace alcove {
namespace {

/// Smallest relative change of a metric that counts (beside the reference's own noise).
constexpr double kRelativeMargin = 0.01;

using RowsByFrame = std::map<FrameKey, const MetricRow*>;

struct FramePair {
    FrameKey frame;
    const MetricRow* base;
    const MetricRow* next;
};

bool stands_in(const MeasuredCell& side, const MetricRow& row, MetricColumn column) {
    const bool is_single = side.round.segments[static_cast<std::size_t>(row.segment)].is_single();
    switch (column) {
    case MetricColumn::cold:
        return stands_in_cold(side.round, row);
    case MetricColumn::converged:
        return stands_in_converged(side.round, side.cell, row);
    case MetricColumn::over_time:
    case MetricColumn::history_cold:
        return row.state == SampleState::cold && !is_single;
    case MetricColumn::history_converged:
        break;
    }
    return row.state == SampleState::converged && is_single;
}

RowsByFrame collect_rows(const MeasuredCell& side, const std::string& metric, MetricColumn column) {
    RowsByFrame rows;
    for (const MetricRow& row : side.rows) {
        if (row.metric == metric && stands_in(side, row, column)) {
            rows[{row.segment, row.frame}] = &row;
        }
    }
    return rows;
}

/// Frames with a value in both; `lopsided` counts those that only one run has a value for.
std::vector<FramePair> pair_rows(const RowsByFrame& base, const RowsByFrame& next,
                                 std::size_t& lopsided) {
    const auto has_value = [](const RowsByFrame& rows, FrameKey frame) {
        const auto found = rows.find(frame);
        return found != rows.end() && found->second->value.has_value();
    };
    std::vector<FramePair> pairs;
    for (const auto& [frame, row] : base) {
        if (row->value && has_value(next, frame)) {
            pairs.push_back({frame, row, next.at(frame)});
        } else if (row->value) {
            ++lopsided;
        }
    }
    for (const auto& [frame, row] : next) {
        lopsided += row->value && !has_value(base, frame) ? 1 : 0;
    }
    return pairs;
}

/// Differences and what they were taken of, one a unit.
struct Units {
    std::vector<double> base;
    std::vector<double> next;
    bool is_by_segment = false;
};

Units make_units(const std::vector<FramePair>& pairs, bool debiased) {
    std::map<int, Units> segments;
    Units frames;
    for (const FramePair& pair : pairs) {
        const double base = debiased ? *pair.base->debiased : *pair.base->value;
        const double next = debiased ? *pair.next->debiased : *pair.next->value;
        for (Units* units : {&frames, &segments[pair.frame.first]}) {
            units->base.push_back(base);
            units->next.push_back(next);
        }
    }
    if (segments.size() < kMinimumRepeatsForInterval) {
        return frames;
    }
    Units means;
    means.is_by_segment = true;
    for (const auto& [segment, units] : segments) {
        means.base.push_back(compute_mean(units.base));
        means.next.push_back(compute_mean(units.next));
    }
    return means;
}

/// The mean floor of BASE, if every frame has one.
double find_floor(const std::vector<FramePair>& pairs) {
    double sum = 0.0;
    for (const FramePair& pair : pairs) {
        if (!pair.base->floor) {
            return 0.0;
        }
        sum += *pair.base->floor;
    }
    return sum / static_cast<double>(pairs.size());
}

Verdict judge_interval(Interval cost, double margin) {
    if (cost.lower > margin) {
        return Verdict::worse;
    }
    if (cost.upper < -margin) {
        return Verdict::better;
    }
    return cost.lower >= -margin && cost.upper <= margin ? Verdict::same : Verdict::unknown;
}

/// Too few units for an interval: they must all agree.
Verdict judge_units(Interval costs, double mean, double margin) {
    if (costs.lower >= -margin && costs.upper <= margin) {
        return Verdict::same;
    }
    if (costs.lower > 0.0 && mean > margin) {
        return Verdict::worse;
    }
    return costs.upper < 0.0 && mean < -margin ? Verdict::better : Verdict::unknown;
}

/// Differences as costs: positive is worse.
Interval turn(Interval difference, bool lower_is_better) {
    return lower_is_better ? difference : Interval{-difference.upper, -difference.lower};
}

void judge(QualityComparison& quality, const std::vector<FramePair>& pairs) {
    const bool debiased = std::all_of(pairs.begin(), pairs.end(), [](const FramePair& pair) {
        return pair.base->debiased && pair.next->debiased;
    });
    const Units units = make_units(pairs, debiased);
    std::vector<double> differences;
    for (std::size_t i = 0; i < units.base.size(); ++i) {
        differences.push_back(units.next[i] - units.base[i]);
    }
    quality.base = compute_mean(units.base);
    quality.next = compute_mean(units.next);
    quality.is_by_segment = units.is_by_segment;
    quality.difference = estimate_across_repeats(differences);
    const double floor = find_floor(pairs);
    quality.margin = std::max(kRelativeMargin * std::abs(quality.base), floor);
    quality.is_margin_floor = floor > 0.0 && quality.margin == floor;
    const Estimate& difference = quality.difference;
    if (difference.interval) {
        quality.p_value = test_paired_means(units.base, units.next).p_value;
        quality.verdict =
            judge_interval(turn(*difference.interval, quality.lower_is_better), quality.margin);
    } else {
        quality.verdict = judge_units(
            turn({difference.minimum, difference.maximum}, quality.lower_is_better),
            quality.lower_is_better ? difference.value : -difference.value, quality.margin);
    }
}

std::optional<QualityComparison> compare_metric(const MeasuredCell& base, const MeasuredCell& next,
                                                const std::string& metric, MetricColumn column,
                                                const ImageComparison& images) {
    std::size_t lopsided = 0;
    const std::vector<FramePair> pairs =
        pair_rows(collect_rows(base, metric, column), collect_rows(next, metric, column), lopsided);
    if (pairs.empty() && lopsided == 0) {
        return std::nullopt;
    }
    QualityComparison quality;
    quality.metric = metric;
    quality.column = column;
    quality.lower_is_better = is_lower_better(next.run.plan(), metric);
    quality.frames = pairs.size();
    quality.verdict = Verdict::unknown;
    if (!pairs.empty()) {
        judge(quality, pairs);
    }
    if (lopsided > 0) {
        quality.verdict = Verdict::unknown;
        quality.note = fmt::format("{} frames have a value in one run only", lopsided);
    }
    if (images.are_identical()) {
        const Estimate& difference = quality.difference;
        quality.verdict = Verdict::same;
        quality.note = lopsided == 0 && difference.minimum == 0.0 && difference.maximum == 0.0
                           ? "images identical"
                           : "images identical: the metric or the reference changed";
    }
    if (column == MetricColumn::history_cold || column == MetricColumn::history_converged) {
        quality.verdict.reset();
        quality.p_value.reset();
    }
    return quality;
}

} // namespace

std::vector<QualityComparison> compare_quality(const MeasuredCell& base, const MeasuredCell& next,
                                               const ImageComparison& images) {
    const auto list_both = [&](std::string_view kind) {
        const std::vector<std::string> measured = list_measured(base.rows, base.run.plan(), kind);
        std::vector<std::string> both = list_measured(next.rows, next.run.plan(), kind);
        std::erase_if(both, [&](const std::string& metric) {
            return std::find(measured.begin(), measured.end(), metric) == measured.end();
        });
        return both;
    };
    std::vector<QualityComparison> result;
    const auto add = [&](std::string_view kind, std::initializer_list<MetricColumn> columns) {
        for (const std::string& metric : list_both(kind)) {
            for (const MetricColumn column : columns) {
                if (auto quality = compare_metric(base, next, metric, column, images)) {
                    result.push_back(std::move(*quality));
                }
            }
        }
    };
    add("image", {MetricColumn::cold, MetricColumn::converged});
    add("temporal", {MetricColumn::over_time});
    add("history", {MetricColumn::history_cold, MetricColumn::history_converged});
    return result;
}

} // namespace alcove
