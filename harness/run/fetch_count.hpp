#pragma once
// What the passes of a round's cells fetch a pixel: a cost that is the same on every device. Asked
// for by `--count-fetches`, since methods are compiled once more and counting is slow.

#include "harness/run/round_stage.hpp"

namespace alcove {

/// One record a cell and pass; the mean over the round's single frames, else over the middle frames
/// of its bursts, each with converged histories. Shaders of the harness (G-buffers, shadow maps)
/// are not counted, nor is what a method computes on the processor. What is fetched under a failing
/// depth test is (core/gl/fetch_counter).
[[nodiscard]] std::vector<FetchRecord> count_fetches(RoundStage& stage);

} // namespace alcove
