#pragma once
// A night held against the store: which times, metrics and images left what their history lets one
// expect. A value; the reports only lay it out.

#include "reports/analysis/history.hpp"
#include "reports/record/store.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace alcove {

enum class NightVerdict {
    slower,
    worse,
    image_changed,
    faster,
    better,
    unconfirmed, ///< a time beyond its fence that the second measurement did not repeat
    same,
    too_little_history,
    not_gated,
};
[[nodiscard]] std::string_view to_text(NightVerdict verdict);
/// Those that make the gate fail: slower, worse, image changed.
[[nodiscard]] bool is_failure(NightVerdict verdict);

/// How differences of a kind are taken. Asserts a kind that has differences: not images.
[[nodiscard]] HistoryRule get_rule(SeriesKind kind);
/// Relative for logarithmic series ("0.05 slower"), else in the series' unit.
[[nodiscard]] double to_change(double difference, const HistoryRule& rule);

struct JudgedPoint {
    NightPoint point;
    HistoryNight judged;
    NightVerdict verdict = NightVerdict::not_gated;
    std::optional<double> second; ///< the second measurement's value
    std::string last_hash;        ///< images: of the last night of the segment; empty if none
};

struct Night {
    StoredRun run;
    std::vector<JudgedPoint> points; ///< in the run's order
    std::size_t past_nights = 0;     ///< of this device and suite in the store

    [[nodiscard]] std::size_t count(NightVerdict verdict) const;
    [[nodiscard]] bool is_failed() const;
};

/// Judges tonight's points. Times beyond their fence are `unconfirmed` until confirm_times.
[[nodiscard]] Night judge_night(const StoredHistory& history, StoredRun run,
                                std::vector<NightPoint> points);

/// Rounds with times that are beyond their fence.
[[nodiscard]] std::set<std::string> list_suspect_rounds(const Night& night);

/// A second measurement of the same night: what it repeats becomes slower or faster.
void confirm_times(Night& night, const std::vector<NightPoint>& second);

/// What the store is to keep of it.
[[nodiscard]] std::vector<NightRow> make_rows(const Night& night);

/// Points of a series of the store, for replay_history.
[[nodiscard]] std::vector<HistoryPoint> list_history_points(const StoredSeries& series);

/// Names that differ in state, pass and metric alone.
[[nodiscard]] bool is_same_cell(const SeriesName& a, const SeriesName& b);

} // namespace alcove
