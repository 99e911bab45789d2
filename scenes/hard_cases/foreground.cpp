#include "scenes/hard_cases/foreground.hpp"

#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/solids.hpp"

#include <numbers>

namespace alcove {

std::unique_ptr<Scene> make_foreground_case(double gap_m) {
    const glm::vec3 grey(0.7f);
    RigidSceneContent content;
    content.meshes = {
        make_box_mesh("wall", grey, {-40.0, -40.0, -11.0}, {40.0, 40.0, -10.0}),
        make_box_mesh("post", grey, {-0.1, -20.0, -10.0 + gap_m}, {0.1, 20.0, -9.8 + gap_m}),
    };
    content.objects = {{"wall", 0}, {"post", 1}};
    content.transforms = {glm::dmat4(1.0), glm::dmat4(1.0)};
    content.walkthrough.cameras = {make_look_at_camera(
        glm::dvec3(0.0), {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, std::numbers::pi / 6.0, 0.1, 100.0)};
    content.ao_radius_m = 0.5;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace alcove
