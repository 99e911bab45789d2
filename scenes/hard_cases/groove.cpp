#include "scenes/hard_cases/groove.hpp"

#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/solids.hpp"

#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

namespace alcove {

std::unique_ptr<Scene> make_groove_case(GrooveAxis axis) {
    // Floor y < 0 and wall z < 0 meet along x. The camera looks at the edge from 45 degrees.
    RigidSceneContent content;
    const glm::vec3 grey(0.7f);
    content.meshes = {
        make_box_mesh("floor", grey, {-40.0, -1.0, -1.0}, {40.0, 0.0, 40.0}),
        make_box_mesh("wall", grey, {-40.0, -0.5, -1.0}, {40.0, 40.0, 0.0}),
    };
    content.objects = {{"floor", 0}, {"wall", 1}};
    content.transforms = {glm::dmat4(1.0), glm::dmat4(1.0)};
    const double side = 4.0 / std::numbers::sqrt2;
    const glm::dvec3 up =
        axis == GrooveAxis::horizontal ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    content.walkthrough.cameras = {make_look_at_camera({0.0, side, side}, glm::dvec3(0.0), up,
                                                       std::numbers::pi / 3.0, 0.1, 100.0)};
    content.ao_radius_m = 0.5;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace alcove
