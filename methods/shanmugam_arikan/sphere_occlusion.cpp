#include "methods/shanmugam_arikan/sphere_occlusion.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// Interval of x / z over a disc in the plane of z (ahead, > 0 in front) and x. All of the axis if
/// the disc reaches the eye's plane.
std::pair<double, double> project_disc(double x, double z, double radius) {
    if (z <= radius) {
        return {-INFINITY, INFINITY};
    }
    // Tangents from the eye: slopes of (z x +- radius s) / (z^2 - radius^2), s^2 = x^2 + z^2 -
    // radius^2.
    const double s = std::sqrt(x * x + z * z - radius * radius);
    const double divisor = z * z - radius * radius;
    return {(z * x - radius * s) / divisor, (z * x + radius * s) / divisor};
}

} // namespace

double compute_cap_solid_angle(double radius, double distance) {
    ALCOVE_ASSERT(radius >= 0.0 && distance > 0.0, "a sphere at a distance");
    const double t = std::min(radius / distance, 1.0);
    return 2.0 * std::numbers::pi * t * t / (1.0 + std::sqrt(1.0 - t * t));
}

double compute_sphere_occlusion_sr(const glm::dvec3& to_center, double radius,
                                   const glm::dvec3& normal) {
    const double distance = glm::length(to_center);
    return compute_cap_solid_angle(radius, distance) *
           std::max(glm::dot(normal, to_center) / distance, 0.0);
}

double compute_far_distance_in_radii(double epsilon_sr) {
    ALCOVE_ASSERT(epsilon_sr > 0.0 && epsilon_sr <= 2.0 * std::numbers::pi,
                  "a part of the hemisphere");
    const double x = epsilon_sr / (2.0 * std::numbers::pi);
    return 1.0 / std::sqrt(x * (2.0 - x));
}

DeviceRectangle compute_ball_bounds(const glm::dvec3& center, double radius,
                                    const glm::dvec2& tangents) {
    DeviceRectangle bounds;
    if (-center.z <= -radius) {
        bounds.high = bounds.low; // wholly behind the eye
        return bounds;
    }
    for (int axis = 0; axis < 2; ++axis) {
        const auto [low, high] = project_disc(center[axis], -center.z, radius);
        bounds.low[axis] = std::clamp(low / tangents[axis], -1.0, 1.0);
        bounds.high[axis] = std::clamp(high / tangents[axis], -1.0, 1.0);
    }
    return bounds;
}

} // namespace alcove
