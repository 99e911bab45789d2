#pragma once
// Scalable ambient obscurance: taps on a spiral over the projected radius, far ones from a depth
// pyramid, so that a tap costs the same however large the radius is on the screen.

#include "core/contract/method.hpp"
#include "methods/common/estimator_method.hpp"
#include "methods/common/kernels.hpp"

namespace alcove {

struct SaoParams {
    double radius = 0.5; ///< metres
    int samples = 11;    ///< a pixel
    int turns = 7;       ///< of the spiral
    KernelRotation rotation = KernelRotation::pixel;
    double bias = 0.01;      ///< in radii above the tangent plane
    double epsilon = 0.01;   ///< in squared radii
    double intensity = 1.0;  ///< in radii
    int first_level_log = 3; ///< log2 of the offset in pixels up to which level 0 is read
    int levels = 5;          ///< of the pyramid beyond level 0
    KernelBorder border = KernelBorder::open;
    EstimatorResolution resolution = EstimatorResolution::full;
    int blur_radius = 4;    ///< pixels on each side; 0: no blur
    int upsample_width = 8; ///< pixels
    double blur_edge = 0.1; ///< in radii off the tangent plane
};

[[nodiscard]] MethodUnit sao_unit();

} // namespace alcove
