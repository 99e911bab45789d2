#include "scenes/hard_cases/foreground.hpp"

#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/solids.hpp"

#include <numbers>

namespace alcove {

namespace {

/// The camera looks at the first mesh from 10 m.
std::unique_ptr<Scene> make_scene(std::vector<Mesh> meshes) {
    RigidSceneContent content;
    for (Mesh& mesh : meshes) {
        content.objects.push_back({mesh.name, content.meshes.size()});
        content.meshes.push_back(std::move(mesh));
        content.transforms.emplace_back(1.0);
    }
    content.walkthrough.cameras = {make_look_at_camera(
        glm::dvec3(0.0), {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, std::numbers::pi / 6.0, 0.1, 100.0)};
    content.ao_radius_m = 0.5;
    return std::make_unique<RigidScene>(std::move(content));
}

Mesh make_wall() {
    return make_box_mesh("wall", glm::vec3(0.7f), {-40.0, -40.0, -11.0}, {40.0, 40.0, -10.0});
}

} // namespace

std::unique_ptr<Scene> make_foreground_case(double gap_m) {
    return make_scene(
        {make_wall(), make_box_mesh("post", glm::vec3(0.7f), {-0.1, -20.0, -10.0 + gap_m},
                                    {0.1, 20.0, -9.8 + gap_m})});
}

std::unique_ptr<Scene> make_slit_case() {
    const glm::vec3 grey(0.7f);
    return make_scene({make_wall(),
                       make_box_mesh("left plate", grey, {-20.0, -20.0, -9.7}, {-0.1, 20.0, -9.6}),
                       make_box_mesh("right plate", grey, {0.1, -20.0, -9.7}, {20.0, 20.0, -9.6})});
}

} // namespace alcove
