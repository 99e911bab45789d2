#pragma once
// Horizon-based ambient occlusion in its classic form: in directions on the screen, how far the
// highest horizon lies above the surface's tangent.

#include "core/contract/method.hpp"
#include "methods/common/estimator_method.hpp"
#include "methods/common/kernels.hpp"

namespace alcove {

struct HbaoParams {
    double radius = 0.5; ///< metres
    int directions = 6;
    int steps = 4;            ///< a direction
    double angle_bias = 10.0; ///< degrees above the tangent
    KernelRotation rotation = KernelRotation::tile;
    bool attenuation = true;
    double strength = 1.0; ///< factor on occlusion
    KernelBorder border = KernelBorder::open;
    EstimatorResolution resolution = EstimatorResolution::full;
    int blur_radius = 3;    ///< pixels on each side; 0: no blur
    int upsample_width = 8; ///< pixels
    double blur_edge = 0.1; ///< in radii off the tangent plane
};

[[nodiscard]] MethodUnit hbao_unit();

} // namespace alcove
