#include "scenes/template_scene/template_scene.hpp"

#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <memory>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

std::unique_ptr<Scene> open_template_scene(const ResolvedParameters& /*parameters*/) {
    RigidSceneContent content;
    content.meshes.push_back(
        make_box_mesh("floor", glm::vec3(0.6f), {-4.0, -0.25, -4.0}, {4.0, 0.0, 4.0}));
    // Sunk into the floor: two faces in one plane would fight for the pixel.
    content.meshes.push_back(
        make_box_mesh("box", {0.7f, 0.5f, 0.3f}, {-0.5, -0.05, -0.5}, {0.5, 1.0, 0.5}));
    content.objects = {{"floor", 0}, {"box", 1}};
    content.transforms.assign(content.objects.size(), glm::dmat4(1.0));
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.5, 1.0, 0.3)), glm::vec3(1.0f)});
    content.lights.ambient = glm::vec3(0.5f);
    content.walkthrough = get_embedded_walkthrough("scenes/template_scene/walkthrough.json");
    content.ao_radius_m = 0.5;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit template_scene_unit() {
    SceneUnit unit;
    unit.name = "template_scene";
    unit.title = "Box on a floor";
    unit.stresses = "nothing: a concave edge all round and plane faces, to copy from";
    unit.license = "CC0-1.0, built by this program";
    unit.reported = false;
    unit.parameters = ParameterTable("template_scene", {});
    unit.open = open_template_scene;
    return unit;
}

} // namespace alcove
