#pragma once
// Upright bars before the sky, near ones before far ones: silhouettes, and little else.

#include "core/contract/scene.hpp"

#include <memory>

namespace alcove {

/// Six bars, square in section and `width_m` wide, turned about their axes, 5 m away and 3 m apart
/// in depth: none is near enough to another to block it. Radius 0.5 m, FOV 60 degrees.
[[nodiscard]] std::unique_ptr<Scene> make_bars_case(double width_m);

} // namespace alcove
