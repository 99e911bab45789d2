#pragma once
// Upright bars before the sky, near ones before far ones: silhouettes, and little else.

#include "core/contract/scene.hpp"

#include <memory>

namespace alcove {

/// Six bars, square in section, turned about their axes, three at 5 m and three at 8 m, 2.6 m
/// apart: up to a width of 1.4 m none is within the radius of 0.5 m of another. FOV 60 degrees.
[[nodiscard]] std::unique_ptr<Scene> make_bars_case(double width_m);

} // namespace alcove
