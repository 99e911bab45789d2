#include "scenes/edge_on_slabs/edge_on_slabs.hpp"

#include "scenes/common/scene_kit.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <memory>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

struct SlabsParameters {
    double thickness_m = 0.02;
};

ParameterTable make_table() {
    return describe_parameters("edge_on_slabs", {real(&SlabsParameters::thickness_m, "thickness")
                                                     .range(0.001, 0.2)
                                                     .log_scale()
                                                     .unit("m")
                                                     .meaning("of every slab")
                                                     .source("ours")});
}

std::unique_ptr<Scene> open_edge_on_slabs(const ResolvedParameters& resolved) {
    const double half = 0.5 * make_table().bind<SlabsParameters>(resolved).thickness_m;
    SceneKit kit;
    kit.add(make_box_mesh("floor", glm::vec3(0.58f), {-4.0, -0.3, -1.4}, {4.0, 0.0, 5.0}));
    kit.add(make_box_mesh("wall", {0.62f, 0.64f, 0.68f}, {-3.9, -0.05, -1.3}, {3.9, 3.2, -1.0}));
    // Level slabs on the left, on two posts that pass through them; none touches the wall.
    for (int i = 0; i < 7; ++i) {
        const double y = 0.3 + 0.35 * i;
        kit.add(make_box_mesh("shelf " + std::to_string(i), {0.75f, 0.6f, 0.42f},
                              {-2.1, y - half, -0.75}, {-0.2, y + half, 0.45}));
    }
    for (const double x : {-1.95, -0.35}) {
        kit.add(make_box_mesh(x < -1.0 ? "left post" : "right post", glm::vec3(0.35f),
                              {x - 0.04, -0.05, -0.24}, {x + 0.04, 2.7, -0.16}));
    }
    // Upright slabs on the right, in line with the view as the camera passes.
    for (int i = 0; i < 7; ++i) {
        const double x = 0.25 + 0.3 * i;
        kit.add(make_box_mesh("fin " + std::to_string(i), {0.5f, 0.62f, 0.7f},
                              {x - half, -0.05, -0.75}, {x + half, 2.4, 0.45}));
    }
    // Held by the wall; above the camera, so that it is seen from below and then edge-on.
    kit.add(make_box_mesh("awning", {0.7f, 0.42f, 0.38f}, {0.1, 2.62 - half, -1.05},
                          {2.3, 2.62 + half, 0.7}));
    RigidSceneContent content = kit.take();
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(-0.4, 1.0, 0.9)), glm::vec3(0.9f)});
    content.lights.ambient = glm::vec3(0.48f);
    content.walkthrough = get_embedded_walkthrough("scenes/edge_on_slabs/walkthrough.json");
    content.ao_radius_m = 0.4;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit edge_on_slabs_unit() {
    SceneUnit unit;
    unit.name = "edge_on_slabs";
    unit.title = "Thin slabs seen edge-on";
    unit.stresses = "surfaces that shrink to a line of less than a pixel and grow again: thickness "
                    "heuristics, faces between two pixel centres, grazing angles";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_edge_on_slabs;
    return unit;
}

} // namespace alcove
