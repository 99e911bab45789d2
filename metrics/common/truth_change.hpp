#pragma once
// Change of truth that is more than the reference's own noise.

#include "core/contract/temporal_metric.hpp"

namespace alcove {

/// How many standard deviations of the reference's noise a change must exceed to be one of truth: 4
/// leave 6 of 100000 pixels wrong if the noise is normal.
inline constexpr double kClearOfNoise = 4.0;

/// The larger of `wanted` and kClearOfNoise x the noise of warp(ref_(t-k)) - ref_t, RMS((its half A
/// - its half B) / 2) over the surface pixels that are valid at that k, for the noisiest k of
/// `earlier`; `wanted` without halves.
[[nodiscard]] float find_change_threshold(const TemporalFrame& frame,
                                          std::span<const EarlierFrame> earlier, double wanted);

} // namespace alcove
