#pragma once
// The walkthrough of a model that comes without one.

#include "core/contract/scene.hpp"
#include "scenes/common/bounds.hpp"

namespace alcove {

inline constexpr int kOrbitFrames = 120;

/// Once around the bounds at a height of 0.35 of the distance, the whole of their sphere in view;
/// `frames` >= 1.
[[nodiscard]] Walkthrough make_orbit(const Bounds& bounds, int frames = kOrbitFrames);

} // namespace alcove
