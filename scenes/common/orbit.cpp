#include "scenes/common/orbit.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove {

Walkthrough make_orbit(const Bounds& bounds, int frames) {
    constexpr double kFov = std::numbers::pi / 3.0;
    const double radius_m = 0.5 * bounds.diagonal();
    const double distance_m = radius_m / std::sin(0.5 * kFov);
    Walkthrough walkthrough;
    walkthrough.name = "orbit";
    for (int frame = 0; frame < frames; ++frame) {
        const double angle = 2.0 * std::numbers::pi * frame / frames;
        const glm::dvec3 direction =
            glm::normalize(glm::dvec3(std::sin(angle), 0.35, std::cos(angle)));
        walkthrough.cameras.push_back(make_look_at_camera(
            bounds.centre() + distance_m * direction, bounds.centre(), {0.0, 1.0, 0.0}, kFov,
            0.05 * radius_m, distance_m + 1.01 * radius_m));
    }
    return walkthrough;
}

} // namespace alcove
