#pragma once
// Numbers of a pixel as colours, as sRGB codes.

#include "core/base/image.hpp"

namespace alcove {

/// How long ago a pixel lost its history: red = just now, darker with age, black from
/// kAgeOfBlack frames on, white = converged; the background is grey. The scale is that of figure 6
/// in Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion using temporal
/// coherence. 2010. `age` in frames; `state` has the channels of HistoryChannel.
inline constexpr float kAgeOfBlack = 32.0f;
[[nodiscard]] Image make_age_map(const Image& age, const Image& state);

/// Why: kept = white, no history = grey, off screen = blue, disocclusion = red, neighbourhood =
/// orange; the background is black.
[[nodiscard]] Image make_cause_map(const Image& state);

/// 0 = black to 1 = white along a scale of rising lightness (black, violet, orange, yellow, white).
/// Values are divided by `range` and clamped.
[[nodiscard]] Image make_scale_map(const Image& values, float range);

} // namespace alcove
