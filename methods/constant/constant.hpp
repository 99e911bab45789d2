#pragma once
// The control that any method must beat: one visibility for all surfaces of a frame, the mean that
// ray tracing finds there.

#include "core/contract/method.hpp"

namespace alcove {

struct ConstantParams {
    double radius = 0.5; ///< metres
    int columns = 64;    ///< of the grid of pixels that is traced
    int rays = 32;       ///< a pixel of it, in two halves
    Falloff falloff = Falloff::linear;
    Weighting weighting = Weighting::cosine;
    Normals normals = Normals::shading;
};

[[nodiscard]] MethodUnit constant_unit();

} // namespace alcove
