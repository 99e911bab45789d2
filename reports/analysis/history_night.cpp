#include "reports/analysis/history_night.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace alcove {
namespace {

using SeriesByName = std::map<SeriesName, const StoredSeries*>;

/// The id of an equal segment of the store; nothing if tonight begins one.
std::optional<std::int64_t> find_segment(const StoredHistory& history,
                                         const StoredSegment& segment) {
    const auto found = std::find_if(
        history.segments.begin(), history.segments.end(), [&](const StoredSegment& known) {
            return known.device == segment.device && known.anchor == segment.anchor &&
                   known.scene == segment.scene && known.reference == segment.reference;
        });
    return found == history.segments.end() ? std::nullopt : std::optional(found->id);
}

bool is_time(SeriesKind kind) {
    return kind == SeriesKind::time || kind == SeriesKind::pass || kind == SeriesKind::input;
}

void judge_images(JudgedPoint& judged, const StoredSeries* series,
                  std::optional<std::int64_t> segment) {
    judged.verdict = NightVerdict::too_little_history;
    if (series == nullptr || !segment) {
        return;
    }
    const auto last =
        std::find_if(series->points.rbegin(), series->points.rend(),
                     [&](const StoredPoint& point) { return point.segment == *segment; });
    if (last != series->points.rend()) {
        judged.last_hash = last->image_hash;
        judged.verdict = last->image_hash == judged.point.image_hash ? NightVerdict::same
                                                                     : NightVerdict::image_changed;
    }
}

NightVerdict judge_difference(const JudgedPoint& judged) {
    if (!judged.judged.fence) {
        return NightVerdict::too_little_history;
    }
    if (!judged.judged.is_beyond()) {
        return NightVerdict::same;
    }
    if (is_time(judged.point.kind)) {
        return NightVerdict::unconfirmed;
    }
    const bool is_higher = *judged.judged.difference > 0.0;
    return is_higher == judged.point.lower_is_better ? NightVerdict::worse : NightVerdict::better;
}

void judge_numbers(JudgedPoint& judged, const StoredSeries* series,
                   std::optional<std::int64_t> segment) {
    // Points of other segments are never looked at: a segment that is new has none of its own.
    constexpr std::int64_t kNew = -1;
    std::vector<HistoryPoint> points;
    if (series != nullptr) {
        points = list_history_points(*series);
    }
    points.push_back({judged.point.value, segment.value_or(kNew), false});
    judged.judged = replay_history(points, get_rule(judged.point.kind)).back();
    judged.verdict = judged.point.kind == SeriesKind::milliseconds ? NightVerdict::not_gated
                                                                   : judge_difference(judged);
}

std::optional<StepKind> find_step(NightVerdict verdict) {
    switch (verdict) {
    case NightVerdict::slower:
        return StepKind::slower;
    case NightVerdict::faster:
        return StepKind::faster;
    case NightVerdict::worse:
        return StepKind::worse;
    case NightVerdict::better:
        return StepKind::better;
    case NightVerdict::image_changed:
        return StepKind::image_changed;
    default:
        return std::nullopt;
    }
}

StoredVerdict make_verdict(const JudgedPoint& judged, StepKind kind, bool is_confirmed) {
    StoredVerdict verdict;
    verdict.kind = kind;
    verdict.is_confirmed = is_confirmed;
    if (judged.point.kind == SeriesKind::images) {
        return verdict;
    }
    const HistoryRule rule = get_rule(judged.point.kind);
    verdict.change = to_change(*judged.judged.difference, rule);
    verdict.fence = to_change(*judged.judged.fence, rule);
    if (judged.second) {
        verdict.second =
            to_change(compute_difference(*judged.second, *judged.judged.baseline, rule), rule);
    }
    return verdict;
}

} // namespace

std::string_view to_text(NightVerdict verdict) {
    constexpr std::array<std::string_view, 9> kTexts{
        "slower",       "worse", "image changed",      "faster",   "better",
        "not repeated", "same",  "too little history", "not gated"};
    return kTexts[static_cast<std::size_t>(verdict)];
}

bool is_failure(NightVerdict verdict) {
    return verdict == NightVerdict::slower || verdict == NightVerdict::worse ||
           verdict == NightVerdict::image_changed;
}

HistoryRule get_rule(SeriesKind kind) {
    ALCOVE_ASSERT(kind != SeriesKind::images, "a kind with differences");
    return {has_logarithm(kind), kind == SeriesKind::quality ? kQualityFence : 0.0};
}

double to_change(double difference, const HistoryRule& rule) {
    return rule.is_logarithmic ? std::expm1(difference) : difference;
}

std::size_t Night::count(NightVerdict verdict) const {
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(),
                      [&](const JudgedPoint& point) { return point.verdict == verdict; }));
}

bool Night::is_failed() const {
    return std::any_of(points.begin(), points.end(),
                       [](const JudgedPoint& point) { return is_failure(point.verdict); });
}

std::vector<HistoryPoint> list_history_points(const StoredSeries& series) {
    std::vector<HistoryPoint> points;
    points.reserve(series.points.size());
    auto verdict = series.verdicts.begin(); // both ascend in run
    for (const StoredPoint& point : series.points) {
        while (verdict != series.verdicts.end() && verdict->run < point.run) {
            ++verdict;
        }
        const bool is_step =
            verdict != series.verdicts.end() && verdict->run == point.run && verdict->is_confirmed;
        points.push_back({point.value, point.segment, is_step});
    }
    return points;
}

Night judge_night(const StoredHistory& history, StoredRun run, std::vector<NightPoint> points) {
    SeriesByName by_name;
    for (const StoredSeries& series : history.series) {
        by_name.emplace(series.name, &series);
    }
    Night night;
    night.past_nights = static_cast<std::size_t>(
        std::count_if(history.runs.begin(), history.runs.end(), [&](const StoredRun& past) {
            return past.device == run.device && past.suite == run.suite;
        }));
    night.run = std::move(run);
    for (NightPoint& point : points) {
        JudgedPoint& judged = night.points.emplace_back();
        judged.point = std::move(point);
        const auto found = by_name.find(judged.point.name);
        const StoredSeries* series = found == by_name.end() ? nullptr : found->second;
        const auto segment = find_segment(history, judged.point.segment);
        if (judged.point.kind == SeriesKind::images) {
            judge_images(judged, series, segment);
        } else {
            judge_numbers(judged, series, segment);
        }
    }
    return night;
}

std::set<std::string> list_suspect_rounds(const Night& night) {
    std::set<std::string> rounds;
    for (const JudgedPoint& judged : night.points) {
        if (judged.verdict == NightVerdict::unconfirmed) {
            rounds.insert(judged.point.round);
        }
    }
    return rounds;
}

void confirm_times(Night& night, const std::vector<NightPoint>& second) {
    std::map<SeriesName, const NightPoint*> by_name;
    for (const NightPoint& point : second) {
        by_name.emplace(point.name, &point);
    }
    for (JudgedPoint& judged : night.points) {
        const auto again = by_name.find(judged.point.name);
        if (judged.verdict != NightVerdict::unconfirmed || again == by_name.end()) {
            continue;
        }
        judged.second = again->second->value;
        if (is_repeated(judged.judged, *judged.second, get_rule(judged.point.kind))) {
            judged.verdict =
                *judged.judged.difference > 0.0 ? NightVerdict::slower : NightVerdict::faster;
        }
    }
}

std::vector<NightRow> make_rows(const Night& night) {
    std::vector<NightRow> rows;
    rows.reserve(night.points.size());
    for (const JudgedPoint& judged : night.points) {
        NightRow& row = rows.emplace_back();
        row.point = judged.point;
        if (const std::optional<StepKind> step = find_step(judged.verdict)) {
            row.verdict = make_verdict(judged, *step, true);
        } else if (judged.verdict == NightVerdict::unconfirmed) {
            const bool is_slower = *judged.judged.difference > 0.0;
            row.verdict =
                make_verdict(judged, is_slower ? StepKind::slower : StepKind::faster, false);
        }
    }
    return rows;
}

bool is_same_cell(const SeriesName& a, const SeriesName& b) {
    const auto strip = [](SeriesName name) {
        name.state.clear();
        name.pass.clear();
        name.metric.clear();
        return name;
    };
    return strip(a) == strip(b);
}

} // namespace alcove
