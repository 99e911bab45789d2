#include "scenes/hard_cases/plane.hpp"

#include "scenes/common/rigid_scene.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace alcove {

std::unique_ptr<Scene> make_plane_case(const PlaneSettings& settings) {
    const double half = settings.half_m;
    const double tilt = glm::radians(settings.tilt_degrees);
    const glm::dvec3 centre(0.0, 0.0, -settings.distance_m);
    const glm::dvec3 right(half, 0.0, 0.0);
    const glm::dvec3 up(0.0, half * std::cos(tilt), -half * std::sin(tilt));
    Mesh mesh;
    mesh.name = "plane";
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        mesh.positions.emplace_back(static_cast<double>(x) * right + static_cast<double>(y) * up);
    }
    mesh.normals.assign(4, glm::vec3(0.0, std::sin(tilt), std::cos(tilt)));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    glm::dmat4 transform(1.0);
    transform[3] = glm::dvec4(centre, 1.0);
    RigidSceneContent content;
    content.meshes = {std::move(mesh)};
    content.objects = {{"plane", 0}};
    content.transforms = {transform};
    content.walkthrough.cameras = {
        make_look_at_camera(glm::dvec3(0.0), {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0},
                            glm::radians(settings.fov_y_degrees), 1e-3, 1e4)};
    content.ao_radius_m = 0.5;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace alcove
