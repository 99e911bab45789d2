#pragma once
// Two runs side by side: what became better, worse, stayed the same, or cannot be told. Times are
// compared through the ratio to each run's own anchor (DESIGN 3.1), images frame by frame. A value;
// the reports only lay it out.

#include "core/base/statistics.hpp"
#include "reports/analysis/series.hpp"
#include "reports/record/record.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alcove {

enum class Verdict { worse, unknown, better, same };
[[nodiscard]] std::string_view to_text(Verdict verdict);

/// The smallest relative change of a time that anybody would act on.
inline constexpr double kDefaultMargin = 0.02;

struct ComparisonOptions {
    double margin = kDefaultMargin; ///< in [0,1); raised to what the A/A pairs can resolve
    /// Repeat r of both runs was taken one after the other (`alcove ab`): repeats are compared pair
    /// by pair, so that what drifts falls on both.
    bool paired = false;
    std::string base_name; ///< for people; empty: the folder's name
    std::string next_name;
};

struct ComparedRun {
    std::string name;
    std::filesystem::path folder;
    ContextRecord context;
    std::string command_line;
};

/// Tests without a shape of noise, of the logs of the ratio to the anchor. They can take a verdict
/// back, never give one: with all their p-values after Holm above 5 %, better and worse are
/// unknown.
struct RankEvidence {
    /// "mann_whitney"; for paired repeats "signed_ranks", which alone keeps the pairs.
    std::string test;
    double p_value = 1.0;
    double adjusted_p_value = 1.0;    ///< Holm over the tests of this time
    std::optional<double> ks_p_value; ///< Kolmogorov-Smirnov; none for paired repeats
    std::optional<double> ks_adjusted_p_value;
    [[nodiscard]] bool is_silent() const; ///< none of them rejects at 5 %
};

/// Envelope of a cell over its anchor's, NEW against BASE.
struct TimeComparison {
    Verdict verdict = Verdict::unknown;
    Estimate base; ///< x anchor
    Estimate next;
    /// NEW / BASE, across repeats; without an interval under 5 repeats on either side. n: repeats
    /// of the smaller side. Minimum and maximum: of pairs, or of all that could be paired.
    Estimate change;
    std::optional<double> p_value;           ///< of "nothing changed"; none without an interval
    std::optional<double> adjusted_p_value;  ///< Holm, over all times of the comparison
    std::optional<double> discovery_p_value; ///< Benjamini-Hochberg, over all times and metrics
    std::optional<RankEvidence> ranks;       ///< none without an interval
    bool is_taken_back = false;              ///< would be better or worse but for the ranks
    double margin = 0.0;                     ///< relative
    double detectable = 0.0;                 ///< larger minimum detectable effect of the two rounds
};

/// Where a time went, in units of the anchor: information without verdict.
struct PartComparison {
    std::string part;       ///< a pass, an "input/...", or "converged"
    bool is_cached = false; ///< on either side: an input cost stored with a reused G-buffer
    std::optional<Estimate> base;
    std::optional<Estimate> next;
    std::optional<Estimate> difference; ///< NEW - BASE
};

enum class MetricColumn { cold, converged, over_time, history_cold, history_converged };
[[nodiscard]] std::string_view to_text(MetricColumn column);

/// A metric of a cell on the frames that have it in both runs. Images are deterministic: nothing
/// here is sampling noise, the interval says how the difference spreads over content.
struct QualityComparison {
    std::string metric;
    MetricColumn column = MetricColumn::cold;
    bool lower_is_better = true;
    std::optional<Verdict> verdict; ///< none for numbers of histories
    double base = 0.0;              ///< mean over frames; debiased where both runs have that
    double next = 0.0;
    std::size_t frames = 0;       ///< in both; 0: no frame has a value in both runs
    Estimate difference;          ///< NEW - BASE, n units
    bool is_by_segment = false;   ///< the unit: segments, else frames
    double margin = 0.0;          ///< in units of the metric
    bool is_margin_floor = false; ///< the margin is the reference's own noise
    /// Of no difference, by t over the units; none under 5 of them or without verdict. Frames of a
    /// burst resemble their neighbours, so that over frames it is smaller than it should be.
    std::optional<double> p_value;
    std::optional<double> discovery_p_value; ///< Benjamini-Hochberg, over all times and metrics
    std::string note;
};

struct PictureChange {
    int frame = 0;
    std::string base; ///< relative to the run's folder
    std::string next;
    std::optional<double> mean_difference; ///< |NEW - BASE| in codes of 255; none: sizes differ
};

struct ImageComparison {
    std::size_t images = 0; ///< with a hash in either run
    std::size_t changed = 0;
    std::vector<std::string> first;      ///< of the changed: "frame 8 cold"
    std::vector<PictureChange> pictures; ///< changed ones that both runs kept
    [[nodiscard]] bool are_identical() const { return images > 0 && changed == 0; }
};

struct ParameterChange {
    std::string name;
    std::optional<std::string> base; ///< none: the method did not have it
    std::optional<std::string> next;
};

struct CellComparison {
    RoundRecord round;      ///< BASE's
    std::string next_round; ///< NEW's id
    CellRecord base;
    CellRecord next;
    std::vector<ParameterChange> parameters; ///< same label, other settings
    std::optional<TimeComparison> time;      ///< none for cells without passes
    std::vector<PartComparison> parts;
    std::vector<QualityComparison> quality;
    ImageComparison images;
};

/// What one run has and the other has not.
struct Unpaired {
    bool is_base = true;
    std::string what;
    std::string reason;
};

/// Expected share of false ones among discoveries.
inline constexpr double kFalseDiscoveryRate = 0.05;

/// What Benjamini and Hochberg find in the matrix of cells by times and metrics. Decides nothing.
struct Discoveries {
    std::size_t times = 0;
    std::size_t all_times = 0;
    std::size_t by_segment = 0; ///< metrics over segments
    std::size_t all_by_segment = 0;
    std::size_t by_frame = 0; ///< metrics over frames: optimistic
    std::size_t all_by_frame = 0;
    [[nodiscard]] std::size_t found() const { return times + by_segment + by_frame; }
    [[nodiscard]] std::size_t tested() const { return all_times + all_by_segment + all_by_frame; }
};

struct Comparison {
    ComparisonOptions options;
    ComparedRun base;
    ComparedRun next;
    std::vector<CellComparison> cells;
    std::vector<Unpaired> unpaired;
    std::vector<std::string> notes; ///< what else differs: builds, processors, methods' sources

    /// Verdicts on times and metrics.
    [[nodiscard]] std::size_t count(Verdict verdict) const;
    /// Times and metrics with a p-value, and those of them that are discoveries.
    [[nodiscard]] Discoveries count_discoveries() const;
};

/// Throws InputError, naming the field and both values, if times or ratios of the two cannot be
/// compared: another anchor_version, device class, renderer, driver version, thread count or timer.
void check_comparable(const ContextRecord& base, const ContextRecord& next);

/// Rounds are matched by scene, walkthrough, target, size, precision, segments, warm and reference,
/// cells by label, method and effects. Reads finished rounds. Throws InputError as check_comparable
/// does, on malformed runs, and if no cell has a partner.
[[nodiscard]] Comparison compare_runs(const RunFolder& base, const RunFolder& next,
                                      const ComparisonOptions& options);

} // namespace alcove
