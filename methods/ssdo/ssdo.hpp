#pragma once
// Screen-space directional occlusion with one bounce: the light of the surroundings from those
// directions that nearby surfaces leave free, and the light that these surfaces send.
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in
// image space. 2009.

#include "core/contract/method.hpp"
#include "methods/common/kernels.hpp"

#include <limits>

namespace alcove {

struct SsdoParams {
    double radius = 0.5; ///< metres
    int samples = 16;    ///< a pixel
    int tile = 4;        ///< pixels a side; tile^2 sets
    double fade = 0.8;   ///< share of the radius
    KernelBorder border = KernelBorder::open;
    double bias = 1.0;                                          ///< half pixel footprints
    double thickness = std::numeric_limits<double>::infinity(); ///< metres
    int layers = 1;
    int views = 0;
    double view_spread = 1.0;     ///< bounding radii
    double view_resolution = 0.5; ///< of the viewer's sides
    bool bounce = true;
    double bounce_strength = 1.0;
    double distance_clamp = 0.05; ///< metres
    bool blur = true;
    double blur_edge = 0.1; ///< radii
};

[[nodiscard]] MethodUnit ssdo_unit();

} // namespace alcove
