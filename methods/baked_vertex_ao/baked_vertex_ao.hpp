#pragma once
// Ambient occlusion traced once at every vertex of the pose at time 0 and interpolated over the
// triangles ever after, wherever they move: what games shipped before screen space, and what a
// screen-space method must beat in price.

#include "core/contract/method.hpp"

namespace alcove {

struct BakedVertexAoParams {
    double radius = 0.5; ///< metres
    int rays = 64;       ///< a vertex, in two halves
    Falloff falloff = Falloff::linear;
    Weighting weighting = Weighting::cosine;
    double inset = 0.02;   ///< share of the way to the centre of the vertex's largest triangle
    double strength = 1.0; ///< factor on occlusion
};

[[nodiscard]] MethodUnit baked_vertex_ao_unit();

} // namespace alcove
