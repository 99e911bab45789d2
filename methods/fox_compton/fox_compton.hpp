#pragma once
// Surface points on a disc on the screen, weighted by their elevation and distance and never tested
// for visibility: the second estimator that temporal SSAO is published with, without history.

#include "core/contract/method.hpp"
#include "methods/common/estimator_method.hpp"
#include "methods/common/kernels.hpp"

namespace alcove {

struct FoxComptonParams {
    double radius = 0.5; ///< metres
    int samples = 16;    ///< a pixel
    KernelRotation rotation = KernelRotation::pixel;
    double cut = 2.0;            ///< in radii
    double grazing_cosine = 0.1; ///< smaller elevations are rejected
    double strength = 1.0;       ///< factor on occlusion
    KernelBorder border = KernelBorder::open;
    EstimatorResolution resolution = EstimatorResolution::full;
    int blur_radius = 2;     ///< pixels on each side; 0: no blur
    int upsample_width = 4;  ///< pixels
    double blur_edge = 0.05; ///< in radii off the tangent plane
};

[[nodiscard]] MethodUnit fox_compton_unit();

} // namespace alcove
