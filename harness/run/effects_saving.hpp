#pragma once
// What leaving effects out saves, and whether the images stay: the planned cells of a round against
// the same with all effects, in turn, on the first frames of its first segment.

#include "harness/run/round_stage.hpp"

#include <vector>

namespace alcove {

/// Of every method cell whose effects are not all. Times: G-buffer and passes, planned over full,
/// paired frame by frame over kSavingRepeats repeats. Both stages stand at other frames afterwards.
inline constexpr int kSavingRepeats = 6;
inline constexpr std::size_t kSavingFrames = 8;
[[nodiscard]] std::vector<SavingRecord>
measure_savings(gl::Context& context, gl::TimerMode timer_mode, const Units& units,
                const PlanRecord& plan, const RoundRecord& round, const Scene& scene);

} // namespace alcove
