#pragma once
// What solids are to each other and to a camera.

#include "core/contract/scene.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace alcove {

/// A triangle in the world.
struct Triangle {
    std::size_t object = 0;
    std::array<glm::dvec3, 3> corners;
};
[[nodiscard]] std::vector<Triangle> collect_triangles(const Scene& scene, const Pose& pose);
/// Only those of objects whose bounding boxes come closer to `point` than `reach_m`.
[[nodiscard]] std::vector<Triangle> collect_triangles_near(const Scene& scene, const Pose& pose,
                                                           const glm::dvec3& point, double reach_m);

/// How free a point is. All triangles of an object that is near must be there.
struct Clearance {
    double distance_m = 1e30;
    std::optional<std::size_t> inside; ///< an object
};
[[nodiscard]] Clearance measure_clearance(const std::vector<Triangle>& triangles,
                                          const glm::dvec3& point);

/// Names of meshes whose faces overlap in one plane by more than a tenth of a millimetre, a pair a
/// line; faces of one object do not count. Quadratic in the number of faces in a plane.
[[nodiscard]] std::string list_shared_faces(const Scene& scene,
                                            const std::vector<Triangle>& triangles);

} // namespace alcove
