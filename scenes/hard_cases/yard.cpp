#include "scenes/hard_cases/yard.hpp"

#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/solids.hpp"

#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace alcove {
namespace {

/// A sphere of radius 1 around 0.
Mesh make_sphere_mesh() {
    constexpr int kRings = 24;
    Contour profile;
    for (int i = 0; i <= kRings; ++i) {
        const double polar = std::numbers::pi * i / kRings;
        const bool is_pole = i == 0 || i == kRings;
        profile.emplace_back(is_pole ? 0.0 : std::sin(polar), -std::cos(polar));
    }
    MeshBuilder builder;
    add_lathe(builder, profile, 2 * kRings);
    return builder.finish("sphere", glm::vec3(0.7f), 180.0);
}

} // namespace

std::unique_ptr<Scene> make_yard_case(const YardSettings& settings) {
    const glm::vec3 grey(0.7f);
    RigidSceneContent content;
    const auto add = [&](Mesh mesh, const glm::dmat4& place) {
        content.objects.push_back({mesh.name, content.meshes.size()});
        content.meshes.push_back(std::move(mesh));
        const glm::dmat4 scale = glm::scale(glm::dmat4(1.0), glm::dvec3(settings.scale));
        content.transforms.push_back(scale * place);
    };
    const glm::dmat4 still(1.0);
    add(make_box_mesh("floor", grey, {-6.0, -0.25, -80.0}, {6.0, 0.0, 6.0}), still);
    add(make_box_mesh("tall box", grey, {-1.0, -0.1, -1.0}, {0.2, 1.2, 0.2}), still);
    add(make_box_mesh("low box", grey, {0.1, -0.1, -0.6}, {1.1, 0.5, 0.6}), still);
    add(make_sphere_mesh(), glm::translate(still, glm::dvec3(-0.6, 0.45, 0.9)) *
                                glm::scale(glm::dmat4(1.0), glm::dvec3(0.5)));
    add(make_box_mesh("post", grey, {1.5, -0.1, 0.9}, {1.56, 1.5, 0.96}), still);
    const auto camera = [&](double aside) {
        const glm::dvec3 from(1.2 + aside, 1.6, 3.6);
        return make_look_at_camera(settings.scale * from,
                                   settings.scale * glm::dvec3(aside, 0.5, 0.0), {0.0, 1.0, 0.0},
                                   glm::radians(settings.fov_y_degrees), 0.1 * settings.scale,
                                   settings.far_m * settings.scale);
    };
    content.walkthrough.cameras = {camera(0.0), camera(0.4), camera(0.0), camera(0.0)};
    content.ao_radius_m = 0.4 * settings.scale;
    content.origin = settings.origin;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace alcove
