#pragma once
// The analytic images on which check values are known (no files needed), scaled to [0,1].

#include "core/base/image.hpp"

#include <functional>

namespace alcove {

/// r = floor((x + y) / 2) / 255 on 256 x 256.
[[nodiscard]] Image make_ramp();
/// The ramp with each code changed by `change(code, x, y)`, clamped to 0..255.
[[nodiscard]] Image make_changed_ramp(const std::function<int(int, int, int)>& change);
/// The ramp plus (hash((y 256 + x) 3) mod 17) - 8.
[[nodiscard]] Image make_noisy_ramp();
/// One code everywhere, 64 x 64.
[[nodiscard]] Image make_constant(int code);
/// One colour everywhere, 64 x 64, three channels.
[[nodiscard]] Image make_colour(int r, int g, int b);
/// The sRGB code of one amount of linear light everywhere, 64 x 64.
[[nodiscard]] Image make_encoded(float linear);
/// Black with one white pixel at (32, 32), 64 x 64.
[[nodiscard]] Image make_firefly();
/// White where x < `edge`, else black, 64 x 64.
[[nodiscard]] Image make_step(int edge);
/// White where x + y is odd, else black, 64 x 64.
[[nodiscard]] Image make_checkerboard();
/// Codes (x, y, floor((x + y) / 2)), 256 x 256, three channels.
[[nodiscard]] Image make_colour_ramp();
/// The colour ramp with each code of channel c changed by (hash((y 256 + x) 3 + c) mod
/// (2 amplitude + 1)) - amplitude, clamped to 0..255.
[[nodiscard]] Image make_noisy_colour_ramp(int amplitude);

} // namespace alcove
