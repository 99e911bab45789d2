#pragma once
// Points in the oriented hemisphere, projected and compared with the depth buffer: the estimator
// that Mattausch, Scherzer and Wimmer (2010) build on, without history. With the step length
// uniform in [0, r] an occluder at distance d is counted with probability 1 - d/r, which is linear
// falloff.

#include "core/contract/method.hpp"
#include "methods/common/kernels.hpp"

namespace alcove {

struct HemisphereSsaoParams {
    double radius = 0.5; ///< metres
    int samples = 16;    ///< a pixel
    KernelDirections directions = KernelDirections::cosine;
    KernelRotation rotation = KernelRotation::pixel;
    double cut = 2.0;  ///< in radii
    double bias = 1.0; ///< in half pixel footprints along the surface
    KernelBorder border = KernelBorder::open;
    double strength = 1.0;   ///< factor on occlusion
    int blur_radius = 2;     ///< pixels on each side; 0: no blur
    double blur_edge = 0.05; ///< in radii off the tangent plane
};

[[nodiscard]] MethodUnit hemisphere_ssao_unit();

} // namespace alcove
