#include "core/base/camera.hpp"

#include "core/base/error.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

Camera make_look_at_camera(const glm::dvec3& position, const glm::dvec3& target,
                           const glm::dvec3& up, double fov_y_radians, double near_m,
                           double far_m) {
    const glm::dvec3 backward = position - target;
    const glm::dvec3 right = glm::cross(up, backward);
    if (!is_finite(position) || !is_finite(target) || !is_finite(up) ||
        glm::length(backward) == 0.0 || glm::length(right) <= 1e-9 * glm::length(backward)) {
        throw InputError("camera", "position, target and up do not span a view", "",
                         "finite numbers, target apart from position, up not along the view axis");
    }
    Camera camera;
    camera.position = position;
    camera.world_from_view[2] = glm::normalize(backward);
    camera.world_from_view[0] = glm::normalize(right);
    camera.world_from_view[1] = glm::cross(camera.world_from_view[2], camera.world_from_view[0]);
    camera.fov_y_radians = fov_y_radians;
    camera.near_m = near_m;
    camera.far_m = far_m;
    check_camera(camera, "camera");
    return camera;
}

void check_camera(const Camera& camera, std::string_view where) {
    if (!is_finite(camera.position)) {
        throw InputError(where, "camera position is not finite");
    }
    if (!(camera.fov_y_radians > 0.0 && camera.fov_y_radians < std::numbers::pi)) {
        throw InputError(where, "field of view out of range",
                         std::to_string(camera.fov_y_radians * 180.0 / std::numbers::pi),
                         "more than 0 and less than 180 degrees");
    }
    if (!(camera.near_m > 0.0 && camera.near_m < camera.far_m && std::isfinite(camera.far_m))) {
        throw InputError(where, "clip planes out of range",
                         std::to_string(camera.near_m) + ", " + std::to_string(camera.far_m),
                         "0 < near < far");
    }
}

glm::dmat4 compute_view_from_object(const Camera& camera, const glm::dmat4& object_to_world) {
    glm::dmat4 relative = object_to_world;
    relative[3] -= glm::dvec4(camera.position, 0.0);
    return glm::dmat4(glm::transpose(camera.world_from_view)) * relative;
}

glm::dvec2 compute_tangents(const Camera& camera, ImageSize size) {
    const double vertical = std::tan(0.5 * camera.fov_y_radians);
    return {vertical * size.width / size.height, vertical};
}

glm::dmat4 compute_projection(const Camera& camera, ImageSize size, bool reversed) {
    const glm::dvec2 tangents = compute_tangents(camera, size);
    const double n = camera.near_m;
    const double f = camera.far_m;
    glm::dmat4 projection(0.0);
    projection[0][0] = 1.0 / tangents.x;
    projection[1][1] = 1.0 / tangents.y;
    projection[2][3] = -1.0;
    projection[2][2] = reversed ? n / (f - n) : -(f + n) / (f - n);
    projection[3][2] = reversed ? f * n / (f - n) : -2.0 * f * n / (f - n);
    return projection;
}

glm::dvec3 compute_pixel_direction(const Camera& camera, ImageSize size, const glm::dvec2& pixel) {
    const glm::dvec2 tangents = compute_tangents(camera, size);
    const glm::dvec3 view((2.0 * pixel.x / size.width - 1.0) * tangents.x,
                          (1.0 - 2.0 * pixel.y / size.height) * tangents.y, -1.0);
    return camera.world_from_view * view;
}

} // namespace alcove
