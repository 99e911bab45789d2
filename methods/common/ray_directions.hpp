#pragma once
// Directions over a hemisphere from points of the unit square, one at a time or a bundle.

#include "core/base/target.hpp"
#include "methods/common/sobol.hpp"

#include <array>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// Unit directions in the order of the points that they came from.
struct BundleDirections {
    alignas(64) std::array<float, SobolBundles::kPoints> x;
    alignas(64) std::array<float, SobolBundles::kPoints> y;
    alignas(64) std::array<float, SobolBundles::kPoints> z;
};

/// An orthonormal frame whose third axis is the unit vector `n`. This work is based on: Duff et al.
/// Building an orthonormal basis, revisited. 2017.
[[nodiscard]] glm::mat3 make_frame(const glm::vec3& n);

/// Directions about the frame's third axis: of density cos / pi, or uniform.
[[nodiscard]] BundleDirections make_directions(const SobolBundles::Points& points,
                                               Weighting weighting, const glm::mat3& frame);

/// One direction of density cos / pi about the unit vector `normal`; `point` in [0,1)^2.
[[nodiscard]] glm::vec3 make_cosine_direction(const glm::vec2& point, const glm::vec3& normal);

} // namespace alcove
