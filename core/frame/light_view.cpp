#include "core/frame/light_view.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace alcove {
namespace {

/// Nearest distance of a perspective light's view, against the scene's radius.
constexpr double kNearShare = 1e-4;

Camera aim(const glm::dvec3& position, const glm::dvec3& direction, double fov_y_radians,
           double near_m, double far_m) {
    const glm::dvec3 up =
        std::abs(direction.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const double reach = std::max(1.0, glm::length(position));
    return make_look_at_camera(position, position + reach * direction, up, fov_y_radians, near_m,
                               far_m);
}

Camera aim_from(const PointLight& light, const glm::dvec3& direction, double fov_y_radians,
                const BoundingSphere& sphere) {
    const double far_m = 1.05 * (glm::distance(light.position, sphere.centre) + sphere.radius_m);
    return aim(light.position, direction, fov_y_radians, kNearShare * sphere.radius_m, far_m);
}

} // namespace

glm::dmat4 compute_projection(const LightView& view) {
    if (!view.is_orthographic()) {
        return compute_projection(view.camera, {1, 1}, false);
    }
    const double half = view.half_extent_m;
    return glm::ortho(-half, half, -half, half, view.camera.near_m, view.camera.far_m);
}

double compute_texel_m(const LightView& view, int side, double along_m) {
    const double half = view.is_orthographic()
                            ? view.half_extent_m
                            : along_m * std::tan(0.5 * view.camera.fov_y_radians);
    return 2.0 * half / side;
}

LightView look_along(const DirectionalLight& light, const BoundingSphere& sphere, double margin) {
    const double radius = margin * sphere.radius_m;
    LightView view;
    view.half_extent_m = radius;
    view.camera = aim(sphere.centre + 2.0 * radius * light.to_light, -light.to_light,
                      0.5 * std::numbers::pi, 0.9 * radius, 3.1 * radius);
    return view;
}

LightView look_along(const PointLight& light, const BoundingSphere& sphere) {
    ALCOVE_ASSERT(light.cone.has_value(), "a spot light");
    // A cone of 180 degrees has no image plane: what lies beyond 170 stays lit.
    const double angle =
        std::min(2.0 * light.cone->outer_radians, 170.0 / 180.0 * std::numbers::pi);
    return {aim_from(light, light.cone->direction, angle, sphere), 0.0};
}

std::array<LightView, 6> look_around(const PointLight& light, const BoundingSphere& sphere) {
    std::array<LightView, 6> faces;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        glm::dvec3 direction(0.0);
        direction[static_cast<int>(i / 2)] = i % 2 == 0 ? 1.0 : -1.0;
        faces[i].camera = aim_from(light, direction, 0.5 * std::numbers::pi, sphere);
    }
    return faces;
}

} // namespace alcove
