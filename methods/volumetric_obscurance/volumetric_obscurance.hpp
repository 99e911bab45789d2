#pragma once
// The share of a ball around the receiver, or of its half above the surface, that lies behind the
// depth buffer, by points spread evenly over its volume: what statistical volumetric obscurance
// takes as its reference (256 points, no rotation, no blur).

#include "core/contract/method.hpp"
#include "methods/common/kernels.hpp"

namespace alcove {

enum class ObscuranceDomain { hemisphere, ball };

struct VolumetricObscuranceParams {
    double radius = 0.5; ///< metres
    int samples = 256;   ///< a pixel
    ObscuranceDomain domain = ObscuranceDomain::hemisphere;
    KernelRotation rotation = KernelRotation::off;
    double cut = 2.0;  ///< in radii
    double bias = 1.0; ///< in half pixel footprints along the surface
    KernelBorder border = KernelBorder::open;
    double strength = 1.0;   ///< factor on occlusion
    int blur_radius = 0;     ///< pixels on each side; 0: no blur
    double blur_edge = 0.05; ///< in radii off the tangent plane
};

[[nodiscard]] MethodUnit volumetric_obscurance_unit();

} // namespace alcove
