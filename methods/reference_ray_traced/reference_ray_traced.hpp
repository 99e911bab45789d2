#pragma once
// The ray-traced reference as a method among methods: truth for a target, as good as its rays.

#include "core/contract/method.hpp"

namespace alcove {

struct ReferenceRayTracedParams {
    double radius = 0.5; ///< metres
    int rays = 128;      ///< a pixel, in two halves
    Falloff falloff = Falloff::linear;
    Weighting weighting = Weighting::cosine;
    Normals normals = Normals::shading;
};

[[nodiscard]] MethodUnit reference_ray_traced_unit();

} // namespace alcove
