#pragma once
// A camera that runs through keys at constant speed.

#include "scenes/common/camera_curve.hpp"

#include <vector>

namespace alcove {

/// Poses at equal distances along the CameraCurve through the keys, `frames` of them from the first
/// key to the last one, both exact; distances are along the curve, right to 1e-9 of its length. The
/// curve's parameter is the sum of chords, and target, up and field of view follow it. Asserts two
/// keys, neighbours apart, and two frames.
[[nodiscard]] std::vector<CameraPose> sample_at_constant_speed(const std::vector<CameraPose>& keys,
                                                               int frames);

} // namespace alcove
