#include "reports/analysis/tradeoff.hpp"

#include "reports/analysis/metric_table.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace alcove {
namespace {

/// Bounds of time-to-quality, over the smallest error of the group.
constexpr std::array kQualitySteps{1.1, 1.25, 1.5, 2.0};

auto get_group(const RoundRecord& round) {
    return std::tuple(round.scene, round.walkthrough, round.target, round.width, round.height,
                      round.precision, round.reference.label);
}

bool is_single(const RoundRecord& round, int segment) {
    return round.segments.at(static_cast<std::size_t>(segment)).is_single();
}

/// Means of segments where there are enough of them for an interval, else frames.
Estimate estimate_over_content(const std::map<int, std::vector<double>>& by_segment) {
    std::vector<double> units;
    if (by_segment.size() >= kMinimumRepeatsForInterval) {
        for (const auto& [segment, values] : by_segment) {
            units.push_back(compute_mean(values));
        }
    } else {
        for (const auto& [segment, values] : by_segment) {
            units.insert(units.end(), values.begin(), values.end());
        }
    }
    return estimate_across_repeats(units);
}

/// The cell's errors in the group's state; nothing if it has none.
std::optional<Estimate> estimate_error(const RoundRecord& round, const CellRecord& cell,
                                       const std::vector<MetricRow>& rows,
                                       const std::string& metric, SampleState state) {
    const bool wants_singles = state == SampleState::converged;
    const SampleState wanted = cell.warm_frames == 0 ? SampleState::cold : state;
    std::map<int, std::vector<double>> values;
    for (const MetricRow& row : rows) {
        const bool is_ours = row.round == round.id && row.cell == cell.id && row.metric == metric &&
                             row.state == wanted && row.value;
        if (is_ours && is_single(round, row.segment) == wants_singles) {
            values[row.segment].push_back(row.debiased.value_or(*row.value));
        }
    }
    if (values.empty()) {
        return std::nullopt;
    }
    return estimate_over_content(values);
}

Interval get_bounds(const Estimate& estimate) {
    return estimate.interval.value_or(Interval{estimate.minimum, estimate.maximum});
}

class TradeoffBuilder {
  public:
    TradeoffBuilder(Tradeoff& tradeoff) : m_tradeoff(tradeoff) {}

    void add(const RoundAnalysis& round, const std::vector<MetricRow>& rows) {
        for (const CellAnalysis& cell : round.cells) {
            if (cell.cell.role != CellRole::method || (cell.cell.has_passes && !cell.ratio)) {
                continue;
            }
            const std::optional<Estimate> error =
                estimate_error(round.round, cell.cell, rows, m_tradeoff.metric, m_tradeoff.state);
            if (!error) {
                continue;
            }
            TradeoffPoint point;
            point.round = round.round.id;
            point.cell = cell.cell.id;
            point.label = cell.cell.label;
            point.method = cell.cell.method;
            point.time = cell.ratio.value_or(Estimate{});
            point.error = *error;
            m_tradeoff.points.push_back(std::move(point));
        }
    }

    void finish() {
        std::stable_sort(m_tradeoff.points.begin(), m_tradeoff.points.end(),
                         [](const TradeoffPoint& a, const TradeoffPoint& b) {
                             return a.time.value < b.time.value;
                         });
        for (TradeoffPoint& point : m_tradeoff.points) {
            mark(point);
        }
    }

  private:
    [[nodiscard]] double get_cost(const TradeoffPoint& point) const {
        return m_tradeoff.lower_is_better ? point.error.value : -point.error.value;
    }

    /// Interval of the error with small as good.
    [[nodiscard]] Interval get_error_bounds(const TradeoffPoint& point) const {
        const Interval bounds = get_bounds(point.error);
        return m_tradeoff.lower_is_better ? bounds : Interval{-bounds.upper, -bounds.lower};
    }

    void mark(TradeoffPoint& point) {
        point.is_on_front = true;
        for (std::size_t i = 0; i < m_tradeoff.points.size(); ++i) {
            const TradeoffPoint& other = m_tradeoff.points[i];
            if (&other == &point) {
                continue;
            }
            const bool is_no_slower = other.time.value <= point.time.value;
            const bool is_no_worse = get_cost(other) <= get_cost(point);
            const bool is_better_somewhere =
                other.time.value < point.time.value || get_cost(other) < get_cost(point);
            point.is_on_front =
                point.is_on_front && !(is_no_slower && is_no_worse && is_better_somewhere);
            point.is_surely_beaten =
                point.is_surely_beaten ||
                (get_bounds(other.time).upper < get_bounds(point.time).lower &&
                 get_error_bounds(other).upper < get_error_bounds(point).lower);
            if (other.method == point.method) {
                continue;
            }
            if (is_no_slower &&
                (!point.equal_time ||
                 get_cost(other) < get_cost(m_tradeoff.points[*point.equal_time]))) {
                point.equal_time = i;
            }
            if (is_no_worse &&
                (!point.equal_error ||
                 other.time.value < m_tradeoff.points[*point.equal_error].time.value)) {
                point.equal_error = i;
            }
        }
    }

    Tradeoff& m_tradeoff;
};

/// Frames from a burst's start until the error is within the bound and stays there; nothing if it
/// never is.
std::optional<int> count_frames(const std::vector<double>& errors, double bound, double sign) {
    int frames = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (sign * errors[i] > sign * bound) {
            frames = static_cast<int>(i) + 1;
        }
    }
    return frames == static_cast<int>(errors.size()) ? std::nullopt : std::optional(frames + 1);
}

std::vector<TimeToQuality> find_quality(const RoundRecord& round, const TradeoffPoint& point,
                                        const std::vector<MetricRow>& rows,
                                        const std::string& metric, double best, double sign) {
    std::map<int, std::vector<double>> bursts;
    for (const MetricRow& row : rows) {
        const bool is_ours = row.round == round.id && row.cell == point.cell &&
                             row.metric == metric && row.state == SampleState::cold && row.value;
        if (is_ours && !is_single(round, row.segment)) {
            bursts[row.segment].push_back(row.debiased.value_or(*row.value));
        }
    }
    std::vector<TimeToQuality> list;
    for (const double step : kQualitySteps) {
        TimeToQuality entry;
        entry.bound = sign > 0.0 ? best * step : best / step;
        entry.frames = bursts.empty() ? std::nullopt : std::optional(0);
        for (const auto& [segment, errors] : bursts) {
            const std::optional<int> frames = count_frames(errors, entry.bound, sign);
            entry.frames = frames && entry.frames ? std::optional(std::max(*frames, *entry.frames))
                                                  : std::nullopt;
        }
        if (entry.frames) {
            entry.time = *entry.frames * point.time.value;
        }
        list.push_back(entry);
    }
    return list;
}

void add_quality(Tradeoff& tradeoff, const std::vector<const RoundAnalysis*>& rounds,
                 const std::vector<MetricRow>& rows) {
    const double sign = tradeoff.lower_is_better ? 1.0 : -1.0;
    double best = tradeoff.points.front().error.value;
    for (const TradeoffPoint& point : tradeoff.points) {
        best = sign * std::min(sign * best, sign * point.error.value);
    }
    for (const TradeoffPoint& point : tradeoff.points) {
        const auto round =
            std::find_if(rounds.begin(), rounds.end(), [&point](const RoundAnalysis* other) {
                return other->round.id == point.round;
            });
        tradeoff.to_quality.push_back(
            find_quality((*round)->round, point, rows, tradeoff.metric, best, sign));
    }
}

bool has_singles(const RoundRecord& round) {
    return std::any_of(round.segments.begin(), round.segments.end(),
                       [](const SegmentRecord& segment) { return segment.is_single(); });
}

} // namespace

std::vector<Tradeoff> compute_tradeoffs(const RunAnalysis& run, const std::string& metric) {
    std::map<decltype(get_group(RoundRecord{})), std::vector<const RoundAnalysis*>> groups;
    std::vector<const RoundAnalysis*> order;
    for (const RoundAnalysis& round : run.rounds) {
        std::vector<const RoundAnalysis*>& group = groups[get_group(round.round)];
        if (group.empty()) {
            order.push_back(&round);
        }
        group.push_back(&round);
    }
    std::vector<Tradeoff> tradeoffs;
    for (const RoundAnalysis* first : order) {
        const std::vector<const RoundAnalysis*>& rounds = groups.at(get_group(first->round));
        Tradeoff tradeoff;
        tradeoff.scene = first->round.scene;
        tradeoff.walkthrough = first->round.walkthrough;
        tradeoff.target = first->round.target;
        tradeoff.reference = first->round.reference.label;
        tradeoff.width = first->round.width;
        tradeoff.height = first->round.height;
        tradeoff.precision = first->round.precision;
        tradeoff.metric = metric.empty() ? first->front_metric : metric;
        tradeoff.lower_is_better = is_lower_better(run.plan, tradeoff.metric);
        tradeoff.state = has_singles(first->round) ? SampleState::converged : SampleState::cold;
        TradeoffBuilder builder(tradeoff);
        for (const RoundAnalysis* round : rounds) {
            builder.add(*round, run.metric_rows);
        }
        if (tradeoff.points.size() < 2) {
            continue;
        }
        builder.finish();
        add_quality(tradeoff, rounds, run.metric_rows);
        tradeoffs.push_back(std::move(tradeoff));
    }
    return tradeoffs;
}

} // namespace alcove
