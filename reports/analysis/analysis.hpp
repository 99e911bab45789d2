#pragma once
// What a run says: ratios, times and errors of every cell with what is known of their error, from
// the rows of the run folder (DESIGN 3.6). A value; the reports only lay it out.

#include "core/base/spread.hpp"
#include "core/base/statistics.hpp"
#include "reports/analysis/fitness.hpp"
#include "reports/record/record.hpp"

#include <optional>
#include <string>
#include <vector>

namespace alcove {

/// A first time of a cell whose round is still running. Shown beside the results, never compared.
struct ProvisionalRow {
    std::string round;
    std::string cell;
    std::string label;
    double time_ms = 0.0; ///< one sample
};

/// Over frames it is content, over repeats noise: two names for two things.
struct Percentiles {
    double p50_ms = 0.0;
    double p95_ms = 0.0;
    double p99_ms = 0.0;
    std::size_t n = 0; ///< frames (content) or repeats (noise)
};

struct PassAnalysis {
    std::string pass; ///< "tssao/reproject"; "input/motion" for an input cost
    Estimate time_ms; ///< median over frames, mean across repeats; an input cost may be negative
    std::optional<double> ns_per_pixel; ///< time over the image's pixels; none for an input cost
    std::optional<double>
        ns_per_sample; ///< of the pass that takes samples, if their number is known
    std::optional<double> fetches_per_pixel; ///< if they were counted; none for an input cost
    bool is_input = false;
    bool is_cached = false;           ///< stored with a reused G-buffer
    bool is_under_resolution = false; ///< median below kResolvedTicks ticks of the timer
};

/// Passes shorter than this many ticks are marked (DESIGN 3.4).
inline constexpr double kResolvedTicks = 50.0;

/// One metric (of any kind) or history number of one cell over the frames of a table.
struct MetricAnalysis {
    std::string metric;
    std::size_t frames = 0;    ///< with a value; the means are over these
    std::size_t undefined = 0; ///< infinite or undefined, left out
    std::string note;          ///< why, for the first one left out
    double value = 0.0;        ///< only if frames > 0, as what follows
    double minimum = 0.0;      ///< over frames
    double maximum = 0.0;
    std::optional<double> debiased; ///< if every frame has one
    std::optional<double> floor;    ///< if every frame has one
    bool is_below_floor = false; ///< shown() is no worse than what the reference's own noise gives
    /// How what is shown spreads over content: over the means of segments where there are enough of
    /// them for an interval, else over frames. Its value weighs segments alike.
    Estimate content;

    /// The debiased mean where there is one, else the plain one.
    [[nodiscard]] double shown() const { return debiased.value_or(value); }
};

/// Envelope of one frame over the repeats.
struct FrameTime {
    int segment = 0;
    int frame = 0;
    double median_ms = 0.0;
    double minimum_ms = 0.0;
    double maximum_ms = 0.0;
    std::size_t n = 0;
};

/// A value of any kind of metric on one frame.
struct FrameError {
    int segment = 0;
    int frame = 0;
    std::string metric;
    std::optional<double> value; ///< debiased where there is one
    std::optional<double> floor;
};

struct CellAnalysis {
    CellRecord cell;
    /// Envelope / the anchor's, cold, paired frame by frame. None for the anchor itself and for a
    /// cell without passes.
    std::optional<Estimate> ratio;
    std::optional<Estimate> time_ms;           ///< AO alone, cold
    std::optional<Estimate> converged_time_ms; ///< equal to time_ms if warm_frames is 0
    /// converged_time_ms / time_ms, repeat by repeat; only for methods with a history.
    std::optional<Estimate> converged_share;
    std::optional<Estimate> input_ms; ///< none if it reads nothing beyond the base G-buffer
    std::optional<Estimate> compose_ms;
    std::optional<Estimate> total_ms; ///< base + input + AO + compose, repeat by repeat
    bool has_cached_input = false;
    std::optional<Percentiles> content;
    std::optional<Percentiles> noise;
    std::optional<SlowFrames> slow_frames; ///< content, in ms: over frames, of medians over repeats
    /// Repeats that lie apart: of the logs of the ratio to the anchor, of the anchor itself those
    /// of its times. Counted, never dropped; none under 5 repeats.
    std::optional<OutlierCount> outliers;
    std::optional<double> lag1;       ///< autocorrelation of the same numbers from repeat to repeat
    std::vector<PassAnalysis> passes; ///< in the order they were recorded, inputs first
    std::optional<Estimate> coverage; ///< sum of divided passes / envelope
    std::vector<MetricAnalysis> cold; ///< bursts, in the plan's order of metrics
    std::vector<MetricAnalysis> converged;         ///< singles
    std::vector<MetricAnalysis> temporal;          ///< metrics over time: bursts, cold
    std::vector<MetricAnalysis> history_cold;      ///< what it says of its history: bursts
    std::vector<MetricAnalysis> history_converged; ///< ... singles
    std::vector<FrameTime> frame_times;
    std::vector<FrameError> frame_errors; ///< cold, all segments
    bool is_on_front = false; ///< no other method of the round is both faster and more accurate

    /// An image metric. Nothing if it has no frame with a value; so for the next two.
    [[nodiscard]] const MetricAnalysis* find(SampleState state, const std::string& metric) const;
    [[nodiscard]] const MetricAnalysis* find_temporal(const std::string& metric) const;
    [[nodiscard]] const MetricAnalysis* find_history(SampleState state,
                                                     const std::string& number) const;
};

/// Is the cell a method's, and may it be held against other rows? Native settings may not (DESIGN
/// 3.8).
[[nodiscard]] bool is_compared(const CellAnalysis& cell);

/// An image metric of one cell over part of the frames, or how many pixels that part has.
struct StratumAnalysis {
    std::string metric;
    std::string stratum;
    std::string cell;
    SampleState state = SampleState::cold; ///< bursts, or singles
    MetricAnalysis value;                  ///< without frames where it is undefined in all
    bool lower_is_better = true;
};

struct RoundAnalysis {
    RoundRecord round;
    RoundDone done;
    std::vector<CellAnalysis> cells;           ///< in the plan's order
    std::vector<std::string> metrics;          ///< image metrics with rows, in the plan's order
    std::vector<std::string> temporal_metrics; ///< so for metrics over time
    std::vector<std::string> history_numbers;  ///< and for numbers of histories
    std::vector<StratumAnalysis> strata;       ///< empty without `run --strata`
    std::string front_metric;         ///< rmse if measured, else the first; empty if there is none
    std::optional<Estimate> base_ms;  ///< base G-buffer
    std::optional<Estimate> aa_ratio; ///< the anchor against itself
    std::optional<double> minimum_detectable_effect; ///< relative, 0.03 = 3 %
    Fitness machine;
    std::optional<double> reference_floor; ///< of front_metric, mean over cells and frames
    std::optional<double> smallest_error;  ///< of front_metric among methods
};

struct RunAnalysis {
    ContextRecord context;
    PlanRecord plan;
    bool is_complete = false;
    bool is_timer_validated = false;    ///< the mode in use was accepted by a trial
    std::vector<RoundAnalysis> rounds;  ///< finished ones
    std::vector<MetricRow> metric_rows; ///< of finished rounds
    std::vector<ProvisionalRow> provisional;

    /// Nothing if the plan does not describe it.
    [[nodiscard]] const MetricDescription* find_metric(const std::string& name) const;
};

/// Reads the finished rounds and computes everything. Provisional rows of finished rounds are
/// dropped. Throws InputError as RunFolder's readers do.
[[nodiscard]] RunAnalysis analyze_run(const RunFolder& run,
                                      std::vector<ProvisionalRow> provisional = {});

} // namespace alcove
