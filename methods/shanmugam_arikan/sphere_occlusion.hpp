#pragma once
// The occlusion of one sphere and how far it reaches, in double: what the shaders compute in float
// and what billboards are sized by.
// This work is based on: Shanmugam, Arikan. Hardware accelerated ambient occlusion techniques on
// GPUs. 2007, equations (2), (3) and (5).

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// Solid angle of the cap that a sphere of radius `radius` at `distance` > 0 subtends, 2 pi t^2 /
/// (1 + sqrt(1 - t^2)) with t = radius / distance: the printed 2 pi (1 - cos asin t) without its
/// cancellation. t >= 1 gives 2 pi.
[[nodiscard]] double compute_cap_solid_angle(double radius, double distance);

/// A_psi of equation (2), steradians: the cap times max(0, cos) of the angle between normal and
/// centre.
[[nodiscard]] double compute_sphere_occlusion_sr(const glm::dvec3& to_center, double radius,
                                                 const glm::dvec3& normal);

/// Distance, in radii, beyond which no receiver gets `epsilon_sr` from a sphere: equation (5) as 1
/// / sqrt(x (2 - x)), x = epsilon / (2 pi). Asserts 0 < epsilon <= 2 pi.
[[nodiscard]] double compute_far_distance_in_radii(double epsilon_sr);

/// A rectangle in normalised device coordinates.
struct DeviceRectangle {
    glm::dvec2 low{-1.0};
    glm::dvec2 high{1.0};
    [[nodiscard]] bool is_empty() const { return low.x >= high.x || low.y >= high.y; }
};

/// The smallest rectangle that shows every visible point of a ball, clipped to the image; empty if
/// none is. `center` in view space (-z ahead), `tangents` of half the angles of view. A ball that
/// holds the eye's plane may cover all of the image.
/// This work is based on: Mara, McGuire. 2D polyhedral bounds of a clipped, perspective-projected
/// 3D sphere. 2013.
[[nodiscard]] DeviceRectangle compute_ball_bounds(const glm::dvec3& center, double radius,
                                                  const glm::dvec2& tangents);

} // namespace alcove
