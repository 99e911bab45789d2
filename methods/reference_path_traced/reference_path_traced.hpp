#pragma once
// Ray-traced light with one diffuse bounce as a method among methods: truth for radiance, as good
// as its rays.

#include "core/contract/method.hpp"
#include "methods/common/path_tracer.hpp"

namespace alcove {

struct ReferencePathTracedParams {
    double radius = 0.5; ///< metres
    int rays = 128;      ///< a pixel, in two halves
    Falloff falloff = Falloff::linear;
    PathReach reach = PathReach::near;
    int bounces = 1;
    Normals normals = Normals::shading;
};

[[nodiscard]] MethodUnit reference_path_traced_unit();

} // namespace alcove
