#include "reports/analysis/tradeoff.hpp"

#include "reports/analysis/metric_table.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace alcove {
namespace {

/// Rounds of which the errors are over the same images.
auto get_group(const RoundRecord& round) {
    std::vector<std::pair<int, int>> segments;
    for (const SegmentRecord& segment : round.segments) {
        segments.emplace_back(segment.begin, segment.end);
    }
    return std::tuple(round.scene, round.walkthrough, round.target, round.width, round.height,
                      round.precision, round.reference.label, round.warm, segments);
}

class TradeoffBuilder {
  public:
    TradeoffBuilder(Tradeoff& tradeoff) : m_tradeoff(tradeoff) {}

    void add(const RoundAnalysis& round) {
        for (const CellAnalysis& cell : round.cells) {
            if (!is_compared(cell) || (cell.cell.has_passes && !cell.ratio)) {
                continue;
            }
            const MetricAnalysis* error = cell.find(m_tradeoff.state, m_tradeoff.metric);
            if (error == nullptr) {
                continue;
            }
            TradeoffPoint point;
            point.round = round.round.id;
            point.cell = cell.cell.id;
            point.label = cell.cell.label;
            point.method = cell.cell.method;
            point.time = cell.ratio.value_or(Estimate{});
            point.error = error->content;
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

/// Errors of a burst's frames, by their distance from its start.
using Burst = std::map<int, double>;

/// Frames from a burst's start until the error is within the bound and stays there; nothing if it
/// never is.
std::optional<int> count_frames(const Burst& errors, double bound, double sign) {
    int frames = 1;
    for (const auto& [distance, error] : errors) {
        if (sign * error > sign * bound) {
            frames = distance + 2;
        }
    }
    return frames > errors.rbegin()->first + 1 ? std::nullopt : std::optional(frames);
}

std::map<int, Burst> collect_bursts(const RoundRecord& round, const CellAnalysis& cell,
                                    const std::string& metric) {
    std::map<int, Burst> bursts;
    for (const FrameError& error : cell.frame_errors) {
        const SegmentRecord& segment = round.segments[static_cast<std::size_t>(error.segment)];
        if (error.metric == metric && error.value && !segment.is_single()) {
            bursts[error.segment][error.frame - segment.begin] = *error.value;
        }
    }
    return bursts;
}

TimeToQuality measure_quality(const std::map<int, Burst>& bursts, double bound, double sign,
                              double time) {
    TimeToQuality entry;
    entry.bound = bound;
    entry.frames = bursts.empty() ? std::nullopt : std::optional(0);
    for (const auto& [segment, errors] : bursts) {
        const std::optional<int> frames = count_frames(errors, bound, sign);
        entry.frames =
            frames && entry.frames ? std::optional(std::max(*frames, *entry.frames)) : std::nullopt;
    }
    if (entry.frames) {
        entry.time = *entry.frames * time;
    }
    return entry;
}

const CellAnalysis& find_cell(const std::vector<const RoundAnalysis*>& rounds,
                              const TradeoffPoint& point) {
    const auto round = std::find_if(rounds.begin(), rounds.end(), [&](const RoundAnalysis* other) {
        return other->round.id == point.round;
    });
    return *std::find_if((*round)->cells.begin(), (*round)->cells.end(),
                         [&](const CellAnalysis& cell) { return cell.cell.id == point.cell; });
}

void add_quality(Tradeoff& tradeoff, const std::vector<const RoundAnalysis*>& rounds) {
    const RoundRecord& round = rounds.front()->round; // the segments are those of all
    const bool has_bursts =
        std::any_of(round.segments.begin(), round.segments.end(),
                    [](const SegmentRecord& segment) { return !segment.is_single(); });
    if (round.warm || !has_bursts) {
        return;
    }
    const double sign = tradeoff.lower_is_better ? 1.0 : -1.0;
    double best = tradeoff.points.front().error.value;
    for (const TradeoffPoint& point : tradeoff.points) {
        best = sign * std::min(sign * best, sign * point.error.value);
    }
    for (const TradeoffPoint& point : tradeoff.points) {
        const std::map<int, Burst> bursts =
            collect_bursts(round, find_cell(rounds, point), tradeoff.metric);
        std::vector<TimeToQuality>& list = tradeoff.to_quality.emplace_back();
        for (const double step : kQualitySteps) {
            const double bound = tradeoff.lower_is_better ? best * step : best / step;
            list.push_back(measure_quality(bursts, bound, sign, point.time.value));
        }
    }
}

bool has_singles(const RoundRecord& round) {
    return std::any_of(round.segments.begin(), round.segments.end(),
                       [](const SegmentRecord& segment) { return segment.is_single(); });
}

} // namespace

Interval get_bounds(const Estimate& estimate) {
    return estimate.interval.value_or(Interval{estimate.minimum, estimate.maximum});
}

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
        tradeoff.warm = first->round.warm;
        tradeoff.metric = metric.empty() ? first->front_metric : metric;
        tradeoff.lower_is_better = is_lower_better(run.plan, tradeoff.metric);
        tradeoff.state = has_singles(first->round) ? SampleState::converged : SampleState::cold;
        TradeoffBuilder builder(tradeoff);
        for (const RoundAnalysis* round : rounds) {
            builder.add(*round);
        }
        if (tradeoff.points.size() < 2) {
            continue;
        }
        builder.finish();
        add_quality(tradeoff, rounds);
        tradeoffs.push_back(std::move(tradeoff));
    }
    return tradeoffs;
}

} // namespace alcove
