#include "scenes/hard_cases/bars.hpp"

#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/solids.hpp"

#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

namespace alcove {

std::unique_ptr<Scene> make_bars_case(double width_m) {
    RigidSceneContent content;
    const double half = 0.5 * width_m;
    content.meshes = {
        make_box_mesh("bar", glm::vec3(0.7f), {-half, -1.5, -half}, {half, 1.5, half})};
    for (int i = 0; i < 6; ++i) {
        content.objects.push_back({"bar " + std::to_string(i), 0});
        // Three in front, three behind that they cover in part.
        const bool is_behind = i % 2 == 1;
        const glm::dvec3 place(2.6 * (i / 2 - 1) + (is_behind ? 0.6 : 0.0), 0.0,
                               is_behind ? -8.0 : -5.0);
        content.transforms.push_back(glm::rotate(glm::translate(glm::dmat4(1.0), place),
                                                 0.2 + 0.25 * i, glm::dvec3(0.0, 1.0, 0.0)));
    }
    content.walkthrough.cameras = {make_look_at_camera(
        glm::dvec3(0.0), {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, std::numbers::pi / 3.0, 0.1, 100.0)};
    content.ao_radius_m = 0.5;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace alcove
