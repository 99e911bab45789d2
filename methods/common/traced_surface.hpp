#pragma once
// What lies where a ray hit: a place with a side, and where rays that leave it start.

#include "core/base/camera.hpp"
#include "core/base/target.hpp"
#include "methods/common/traced_scene.hpp"

#include <array>
#include <optional>

#include <glm/vec3.hpp>

namespace alcove {

struct SurfaceRules {
    Normals normals = Normals::shading;
    /// Start rays of shading normals where no neighbouring facet cuts them off.
    bool terminator_safe = true;
};

/// Relative to the scene's origin. Both sides of a triangle are surfaces; the normal is that of the
/// side that the ray met.
struct TracedSurface {
    glm::vec3 point;
    glm::vec3 normal; ///< unit
    glm::vec3 origin; ///< of rays that leave the surface
    TracedTriangle triangle;
    std::array<float, 3> barycentric; ///< of the point, by corner
};

/// 32 units in the last place of the largest number that took part in placing a point: how far rays
/// start from it.
[[nodiscard]] float compute_lift(const glm::vec3& point, float farthest);

/// `u` and `v` are Embree's coordinates of the hit, `direction` (any length) that of the ray,
/// `distance` its length up to the hit.
[[nodiscard]] TracedSurface find_surface(const TracedTriangle& triangle, float u, float v,
                                         const glm::vec3& direction, float distance,
                                         const SurfaceRules& rules);

/// The surface that a camera ray meets between near and far; `direction` has unit length along the
/// view axis (compute_pixel_direction).
[[nodiscard]] std::optional<TracedSurface>
find_seen_surface(const TracedScene& scene, const glm::vec3& eye, const glm::vec3& direction,
                  const Camera& camera, const SurfaceRules& rules);

} // namespace alcove
