#pragma once
// What deforming and walking figures keep at any time.

#include "core/contract/scene.hpp"
#include "tests/scenes/space_check.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace alcove {

/// An object's mesh as it is at a time, in the world.
[[nodiscard]] Mesh pose_mesh(const Scene& scene, std::size_t object, double time_s);

/// Number of corners whose shading normal looks away from the triangle's own by more than a right
/// angle; triangles under 1e-10 square metres do not count.
[[nodiscard]] std::size_t count_inverted_corners(const Mesh& mesh);

/// Indices of the objects whose names hold `part`.
[[nodiscard]] std::vector<std::size_t> find_objects(const Scene& scene, std::string_view part);

/// Of all objects as they are at a time: what measure_clearance needs.
[[nodiscard]] std::vector<Triangle> collect_posed_triangles(const Scene& scene, double time_s);

/// How walking feet touch the ground over a walkthrough.
struct FootCheck {
    double slide_m = 0.0;     ///< largest move within a frame of a corner of the foot that stands
    double lowest_m = 1e30;   ///< of all corners and frames
    double highest_m = -1e30; ///< of the lowest corner of the foot that stands
};
/// `feet` are objects, left and right. The one that moves less within a frame stands.
[[nodiscard]] FootCheck check_feet(const Scene& scene, std::size_t left, std::size_t right,
                                   int first_frame, int end_frame);

/// Every `stride`-th frame: the smallest distance of the camera from all surfaces.
[[nodiscard]] double measure_camera_clearance(const Scene& scene, std::size_t stride);

} // namespace alcove
