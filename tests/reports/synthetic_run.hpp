#pragma once
// A complete run folder without a renderer: times and errors follow formulas that a test can do by
// hand.

#include "reports/record/record.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <filesystem>
#include <string>

namespace alcove::synthetic {

struct Options {
    int repeats = 6;
    int finished_rounds = 2; ///< of two
    bool hostile = false;    ///< markup and script ends in every text that people read
    bool images = false;
    bool radiance = false; ///< the first round measures pictures
};

/// Segments of a round: three bursts of 16 and eight singles, as the default suite has for 96
/// frames.
inline constexpr int kFrames = 96;
/// The first round has a film, the second none.
inline constexpr SegmentRecord kFilm{40, 48};
/// Frames whose pictures are kept.
inline constexpr int kImageFrames[] = {6, 54, 90};

/// What `method` costs in units of the anchor in the mean over repeats: exact, because the repeats'
/// factors are symmetric in the logarithm.
[[nodiscard]] double true_ratio(const std::string& cell);
/// The rmse of every frame of a cell; tssao starts at three times its converged error and halves it
/// every frame.
[[nodiscard]] double true_rmse(const std::string& cell, int frames_since_reset);
/// The reference's floor for rmse.
inline constexpr double kRmseFloor = 0.004;
/// Temporal flicker of every burst frame but the first, and its floor.
[[nodiscard]] double true_flicker(const std::string& cell);
inline constexpr double kFlickerFloor = 0.002;
/// tssao takes these samples a pixel on a burst's first frame, afterwards, and converged.
inline constexpr double kFirstSamples = 64.0;
inline constexpr double kLaterSamples = 8.0;
inline constexpr double kConvergedSamples = 4.0;
/// Held frames that are timed undivided at each end and in each repeat.
inline constexpr int kHeldFrames = 4;
/// Anchor's envelope in nanoseconds: 4 ms, with 20 % content and a drift of 5 % a repeat.
[[nodiscard]] double anchor_ns(int frame, int repeat);
/// One method's factor in a repeat: exp(0.002 (repeat - (repeats - 1) / 2)).
[[nodiscard]] double repeat_factor(int repeat, int repeats);

[[nodiscard]] ContextRecord make_context();
[[nodiscard]] PlanRecord make_plan(const Options& options);
[[nodiscard]] std::vector<SampleRow> make_samples(const PlanRecord& plan, const RoundRecord& round);
[[nodiscard]] std::vector<MetricRow> make_metrics(const RoundRecord& round);

/// Writes all of it and returns the opened folder.
RunFolder write_run(const std::filesystem::path& path, const Options& options);

using alcove::TemporaryFolder;

} // namespace alcove::synthetic
