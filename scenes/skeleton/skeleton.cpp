#include "scenes/skeleton/skeleton.hpp"

#include "scenes/common/animated_scene.hpp"
#include "scenes/common/skeleton_figure.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace alcove {
namespace {

struct SkeletonParameters {
    double detail = 1.0;
    double thickness = 0.025;
    double speed = 1.2;
};

ParameterTable make_table() {
    using P = SkeletonParameters;
    return describe_parameters(
        "skeleton", {real(&P::detail, "detail")
                         .range(0.1, 16.0)
                         .log_scale()
                         .unit("1")
                         .meaning("number of the skeleton's vertices, relative to the default")
                         .source("ours"),
                     real(&P::thickness, "thickness")
                         .range(0.005, 0.08)
                         .log_scale()
                         .unit("m")
                         .meaning("diameter of the shafts of the long bones; the others follow")
                         .source("ours"),
                     real(&P::speed, "speed")
                         .range(0.2, 3.0)
                         .unit("m/s")
                         .meaning("of the walk; a cycle of two steps is 1 m long")
                         .source("ours")});
}

constexpr double kMiddle_s = 2.0; ///< when the walker is at x = 0
constexpr double kHalfWay = 7.0;  ///< metres; there it rests, at both ends
/// Of the gait at x = 0: at both ends of the way both feet stand.
constexpr double kPhase = 0.06;
static_assert(kHalfWay == static_cast<int>(kHalfWay), "whole cycles of 1 m");

double measure_way(double speed, double time_s) {
    return std::clamp(speed * (time_s - kMiddle_s), -kHalfWay, kHalfWay);
}

/// From the cut on the camera goes along with the walker.
Walkthrough make_walkthrough(double speed) {
    Walkthrough walkthrough = get_embedded_walkthrough("scenes/skeleton/walkthrough.json");
    const auto first = static_cast<std::size_t>(walkthrough.cuts.back());
    for (std::size_t frame = first; frame < walkthrough.cameras.size(); ++frame) {
        walkthrough.cameras[frame].position.x +=
            measure_way(speed, static_cast<double>(frame) * walkthrough.step_s);
    }
    return walkthrough;
}

std::unique_ptr<Scene> open_skeleton(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<SkeletonParameters>(resolved);
    AnimatedSceneContent content;
    const auto add = [&content](Mesh mesh) {
        AnimatedObject object;
        object.object = {mesh.name, content.meshes.size(), ObjectMotion::still};
        content.objects.push_back(std::move(object));
        content.meshes.push_back(std::move(mesh));
    };
    add(make_box_mesh("floor", {0.5f, 0.5f, 0.52f}, {-14.0, -0.3, -9.5}, {14.0, 0.0, 5.0}));
    add(make_box_mesh("wall", {0.68f, 0.66f, 0.62f}, {-13.5, -0.05, -9.3}, {13.5, 5.0, -9.0}));
    MeshBuilder posts;
    for (int i = -6; i <= 6; ++i) {
        const double x = 2.0 * i;
        add_box(posts, {x - 0.15, -0.06, -9.05}, {x + 0.15, 4.4, -8.75});
    }
    add(posts.finish("posts", {0.55f, 0.5f, 0.44f}, 0.0));

    SkeletonMeshes skeleton = make_skeleton(parameters.thickness, parameters.detail);
    const std::size_t first_mesh = content.meshes.size();
    for (std::size_t limb = 0; limb < kLimbs; ++limb) {
        const std::size_t mesh = skeleton.of_limb[limb];
        AnimatedObject object;
        object.object = {skeleton.meshes[mesh].name + "#" + std::to_string(limb), first_mesh + mesh,
                         ObjectMotion::rigid};
        object.node = 1 + limb;
        content.objects.push_back(std::move(object));
    }
    for (Mesh& mesh : skeleton.meshes) {
        content.meshes.push_back(std::move(mesh));
    }
    content.nodes = [speed = parameters.speed](double time_s) {
        const double way = measure_way(speed, time_s);
        const WalkerBody& body = get_skeleton_body();
        const WalkPose pose = pose_walk(body, way / body.cycle + kPhase,
                                        glm::translate(glm::dmat4(1.0), glm::dvec3(way, 0.0, 0.0)));
        std::vector<glm::dmat4> nodes{glm::dmat4(1.0)};
        nodes.insert(nodes.end(), pose.begin(), pose.end());
        return nodes;
    };
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(-0.4, 0.9, 0.7)), glm::vec3(0.95f, 0.92f, 0.85f)});
    content.lights.ambient = glm::vec3(0.46f, 0.48f, 0.52f);
    content.walkthrough = make_walkthrough(parameters.speed);
    content.ao_radius_m = 0.3;
    return std::make_unique<AnimatedScene>(std::move(content));
}

} // namespace

SceneUnit skeleton_unit() {
    SceneUnit unit;
    unit.name = "skeleton";
    unit.title = "Walking skeleton";
    unit.stresses = "thin fast bones before a far wall: histories of a few pixels, what samples "
                    "miss, background uncovered every frame, feet in and out of contact";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_skeleton;
    return unit;
}

} // namespace alcove
