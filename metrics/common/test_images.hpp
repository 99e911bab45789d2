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

} // namespace alcove
