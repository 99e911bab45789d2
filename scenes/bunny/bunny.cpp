#include "scenes/bunny/bunny.hpp"

#include "core/base/error.hpp"
#include "scenes/common/bunny_mesh.hpp"
#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <memory>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

enum class Path { standard, orbit_and_rest };

struct BunnyParameters {
    double turn = 0.0;
    Path walkthrough = Path::standard;
};

ParameterTable make_table() {
    return describe_parameters(
        "bunny",
        {real(&BunnyParameters::turn, "turn")
             .range(0.0, 20.0)
             .unit("degrees a frame")
             .meaning("above 0 the camera stands still and the bunny turns about its "
                      "vertical axis at this speed")
             .source("ours"),
         choice(&BunnyParameters::walkthrough, "walkthrough", {"default", "orbit_and_rest"})
             .meaning("once around the bunny, or 300 frames of slow orbit and 300 of "
                      "rest; with turn the camera stands still")
             .source("ours")});
}

/// The file's track turns by a degree a frame.
Walkthrough make_turning_walkthrough(double degrees_a_frame) {
    Walkthrough walkthrough = get_embedded_walkthrough("scenes/bunny/walkthrough_turning.json");
    for (ObjectTrack& track : walkthrough.tracks) {
        for (TrackKey& key : track.keys) {
            key.degrees *= degrees_a_frame;
        }
    }
    return walkthrough;
}

Walkthrough choose_walkthrough(const BunnyParameters& parameters) {
    if (parameters.turn > 0.0) {
        if (parameters.walkthrough != Path::standard) {
            throw InputError("bunny", "turn and walkthrough exclude each other");
        }
        return make_turning_walkthrough(parameters.turn);
    }
    return get_embedded_walkthrough(parameters.walkthrough == Path::standard
                                        ? "scenes/bunny/walkthrough.json"
                                        : "scenes/bunny/walkthrough_orbit_and_rest.json");
}

std::unique_ptr<Scene> open_bunny(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<BunnyParameters>(resolved);
    RigidSceneContent content;
    content.meshes.push_back(read_bunny("bunny"));
    content.meshes.push_back(
        make_box_mesh("floor", glm::vec3(0.55f), {-2.5, -0.25, -2.5}, {2.5, 0.0, 2.5}));
    content.objects = {{"bunny", 0}, {"floor", 1}};
    content.transforms.assign(content.objects.size(), glm::dmat4(1.0));
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.4, 1.0, 0.6)), glm::vec3(1.1f, 1.05f, 1.0f)});
    content.lights.ambient = glm::vec3(0.45f, 0.48f, 0.52f);
    content.walkthrough = choose_walkthrough(parameters);
    content.ao_radius_m = 0.2;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit bunny_unit() {
    SceneUnit unit;
    unit.name = "bunny";
    unit.title = "Stanford bunny on a floor";
    unit.stresses = "scanned surface: folds, ears with deep creases, contact of the feet with the "
                    "floor, shading normals on coarse triangles";
    unit.license = "unstated, Stanford University Computer Graphics Laboratory (the npm package "
                   "says public domain)";
    unit.parameters = make_table();
    unit.find_obstacle = find_bunny_obstacle;
    unit.open = open_bunny;
    return unit;
}

} // namespace alcove
