#pragma once
// One round (DESIGN 3.1 to 3.5): R timing replays in which all cells share every frame in shuffled
// order, then one capture replay that takes images and stores no time.

#include "harness/run/round_stage.hpp"

#include <filesystem>
#include <functional>

namespace alcove {

struct RoundResult {
    std::vector<SampleRow> samples;
    std::vector<MetricRow> metrics;
    RoundDone done;
};

struct RoundProgress {
    std::size_t done = 0; ///< frames of all replays
    /// Up to the end; where repeats go on until intervals are narrow, up to the next look at them.
    std::size_t all = 0;
    bool is_timing = false; ///< else the capture
};

/// What the caller hears from a round while it runs.
struct RoundEvents {
    /// Before each timing replay ("repeat 0 ROUND") and the capture ("capture ROUND").
    std::function<void(const std::string&)> before_step = [](const std::string&) {};
    /// After each frame of each replay.
    std::function<void(const RoundProgress&)> progress = [](const RoundProgress&) {};
    /// After each timing replay, with all samples so far and the repeats that are finished.
    std::function<void(const std::vector<SampleRow>&, int)> repeat_done =
        [](const std::vector<SampleRow>&, int) {};
};

/// Everything passed by reference must outlive the call. `run_folder` is where pictures go. Throws
/// FailureError on a GL error and InputError on broken data.
[[nodiscard]] RoundResult run_round(gl::Context& context, gl::TimerMode timer_mode,
                                    const Units& units, const PlanRecord& plan,
                                    const RoundRecord& round, const Scene& scene,
                                    const std::filesystem::path& run_folder,
                                    const RoundEvents& events);

} // namespace alcove
