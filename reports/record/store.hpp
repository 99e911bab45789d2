#pragma once
// The store: one SQLite file that keeps runs over time. A night is appended in one transaction, so
// that a kill loses at most the night in flight. The tables are documented in reports/README.md.

#include "core/base/statistics.hpp"

#include <compare>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// `PRAGMA user_version`. Older files are brought to it, newer ones refused.
inline constexpr int kStoreSchemaVersion = 2;

struct StoredRun {
    std::int64_t id = 0; ///< ascending in time; given by the store
    std::string utc;     ///< ISO 8601
    std::string build;   ///< hash of sources, compiler and flags
    std::string commit;  ///< as the caller names it; may be empty
    std::string device;  ///< as in SeriesName
    std::string device_class;
    std::string timer_mode;
    std::string suite;
    std::string folder; ///< of the run; relative to the store's folder where it can be
};

/// time: envelope / anchor. pass, input: parts / anchor. milliseconds: never gated. quality: a
/// metric. images: the hash of all images of a cell.
enum class SeriesKind { time, pass, input, milliseconds, quality, images };
[[nodiscard]] std::string_view to_text(SeriesKind kind);

/// Times, whose values are positive and compared by their logarithms. An input cost is a difference
/// and may be negative.
[[nodiscard]] bool has_logarithm(SeriesKind kind);

/// What makes points of two nights the same series: device, suite, the cell by names, pass, metric.
struct SeriesName {
    std::string device; ///< what draws, without versions
    std::string suite;  ///< the experiment's name
    std::string scene;
    std::string walkthrough;
    std::string frames; ///< "0:16 40:56"; begins with "warm " for histories converged first
    std::string target;
    std::string size; ///< "256x192"
    std::string precision;
    std::string method; ///< label with its parameters
    std::string effects;
    std::string state;  ///< "cold", "converged"; "all" for images
    std::string pass;   ///< "envelope", a pass, "input/..."; empty for metrics and images
    std::string metric; ///< "x anchor", "ms", a metric's name, "images"
    friend auto operator<=>(const SeriesName&, const SeriesName&) = default;
};

/// What must be equal for two points of a series to be compared. What a series does not depend on
/// is empty.
struct StoredSegment {
    std::int64_t id = 0;
    std::string device;    ///< renderer, driver, CPU features, timer
    std::string anchor;    ///< version
    std::string scene;     ///< hash of geometry and cameras
    std::string reference; ///< method, parameters, rays, hash of its sources
};

struct StoredPoint {
    std::int64_t run = 0;
    std::int64_t segment = 0;
    double value = 0.0; ///< finite; for images their number
    std::optional<Interval> interval;
    std::int64_t n = 0;     ///< repeats, frames or images
    std::string image_hash; ///< of kind images alone
};

/// slower, faster: a time. worse, better: a metric. image_changed.
enum class StepKind { slower, faster, worse, better, image_changed };
[[nodiscard]] std::string_view to_text(StepKind kind);

struct StoredVerdict {
    std::int64_t run = 0;
    StepKind kind = StepKind::slower;
    double change = 0.0; ///< tonight / baseline - 1 of logarithmic series, else tonight - baseline
    double fence = 0.0;  ///< in the same unit
    std::optional<double> second; ///< the second measurement's change
    bool is_confirmed = false;
};

struct StoredSeries {
    std::int64_t id = 0;
    SeriesName name;
    SeriesKind kind = SeriesKind::time;
    bool lower_is_better = true;
    std::vector<StoredPoint> points;     ///< ascending in run
    std::vector<StoredVerdict> verdicts; ///< so
};

/// All of a store.
struct StoredHistory {
    std::vector<StoredRun> runs;         ///< ascending in id
    std::vector<StoredSegment> segments; ///< so
    std::vector<StoredSeries> series;    ///< so
};

/// One point of a night before it has ids.
struct NightPoint {
    SeriesName name;
    SeriesKind kind = SeriesKind::time;
    bool lower_is_better = true;
    StoredSegment segment; ///< without id
    double value = 0.0;
    std::optional<Interval> interval;
    std::int64_t n = 0;
    std::string image_hash;
    std::string round; ///< of the run folder, to measure it again; not stored
};

struct NightRow {
    NightPoint point;
    std::optional<StoredVerdict> verdict; ///< its run is given by the store
};

class Store {
  public:
    /// Opens, creates or migrates. ":memory:" is a store that is gone with the object. Throws
    /// InputError for a file that is no store or one of a newer schema, FailureError if it cannot
    /// be written to.
    explicit Store(const std::filesystem::path& path);
    ~Store();
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    /// Appends a run with its points and verdicts, all or nothing; returns the run's id. Names are
    /// unique within `rows`.
    std::int64_t append(const StoredRun& run, const std::vector<NightRow>& rows);

    /// Throws InputError on numbers that are not finite, kinds that do not exist, and points of
    /// runs or series that are not there.
    [[nodiscard]] StoredHistory read() const;

  private:
    struct Tables;
    std::unique_ptr<Tables> m_tables;
};

} // namespace alcove
