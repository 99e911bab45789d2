#include "scenes/colour_blocks/colour_blocks.hpp"

#include "scenes/common/scene_kit.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <memory>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

enum class Path { moving, turning, light };

struct ColourBlocksParameters {
    Path walkthrough = Path::moving;
};

/// Blocks stand this deep in the floor, metres: in contact, without two faces in one plane.
constexpr double kSink = 0.004;
constexpr double kLightDegreesPerS = 90.0; ///< once around in 120 frames at 1/30 s
constexpr glm::vec3 kFloor(0.75f);
constexpr glm::vec3 kRed(0.75f, 0.08f, 0.06f);
constexpr glm::vec3 kBlue(0.07f, 0.14f, 0.72f);
constexpr glm::vec3 kYellow(0.85f, 0.7f, 0.05f);

ParameterTable make_table() {
    return describe_parameters(
        "colour_blocks",
        {choice(&ColourBlocksParameters::walkthrough, "walkthrough", {"moving", "turning", "light"})
             .meaning("under a still camera blocks slide and turn about each other, a panel turns "
                      "its yellow side away, or the light turns once around resting blocks")
             .source("ours; Ritschel, Grosch and Seidel 2009, figures 3 and 4")});
}

Mesh make_block(const char* name, const glm::vec3& albedo, const glm::dvec3& size) {
    return make_box_mesh(name, albedo, {-0.5 * size.x, -kSink, -0.5 * size.z},
                         {0.5 * size.x, size.y, 0.5 * size.z});
}

/// White but for its side towards +z.
Mesh make_panel() {
    Mesh mesh = make_block("yellow", glm::vec3(1.0f), {1.2, 0.95, 0.16});
    for (const glm::vec3& normal : mesh.normals) {
        mesh.colors.push_back(normal.z > 0.5f ? kYellow : kFloor);
    }
    return mesh;
}

const char* find_file(Path path) {
    switch (path) {
    case Path::moving:
        return "scenes/colour_blocks/walkthrough.json";
    case Path::turning:
        return "scenes/colour_blocks/walkthrough_turning.json";
    case Path::light:
        break;
    }
    return "scenes/colour_blocks/walkthrough_light.json";
}

std::unique_ptr<Scene> open_colour_blocks(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<ColourBlocksParameters>(resolved);
    SceneKit kit;
    kit.add(make_box_mesh("floor", kFloor, {-3.0, -0.25, -2.5}, {3.0, 0.0, 2.5}));
    if (parameters.walkthrough != Path::turning) {
        kit.add(make_block("red", kRed, {0.7, 0.7, 0.7}), make_place({-0.95, 0.0, -0.25}, 0.3));
        kit.add(make_block("blue", kBlue, {0.55, 1.1, 0.55}), make_place({0.1, 0.0, -0.75}, -0.2));
        kit.add(make_block("yellow", kYellow, {0.8, 0.45, 0.5}), make_place({0.85, 0.0, 0.2}, 0.5));
        kit.add(make_block("small red", kRed, {0.28, 0.28, 0.28}),
                make_place({-0.25, 0.0, 0.75}, 0.7));
    } else {
        // The floor before the yellow side and the block on it receive its light.
        kit.add(make_panel(), make_place({0.0, 0.0, -0.5}, 0.25));
        kit.add(make_block("white", kFloor, {0.4, 0.5, 0.4}), make_place({0.95, 0.0, 0.35}, 0.4));
        kit.add(make_block("red", kRed, {0.45, 0.45, 0.45}), make_place({-1.15, 0.0, -0.2}, 0.5));
        kit.add(make_block("blue", kBlue, {0.4, 0.8, 0.4}), make_place({1.25, 0.0, -0.75}, 0.1));
    }
    RigidSceneContent content = kit.take();
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.55, 1.0, 0.75)), glm::vec3(1.0f, 0.97f, 0.9f)});
    content.lights.ambient = glm::vec3(0.45f, 0.48f, 0.52f);
    content.walkthrough = get_embedded_walkthrough(find_file(parameters.walkthrough));
    if (parameters.walkthrough == Path::light) {
        content.light_degrees_per_s = kLightDegreesPerS;
    }
    content.ao_radius_m = 0.5;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit colour_blocks_unit() {
    SceneUnit unit;
    unit.name = "colour_blocks";
    unit.title = "Coloured blocks on a floor";
    unit.stresses = "colour that travels: shadows with a hue, light that bounces from saturated "
                    "faces, senders that turn out of sight";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_colour_blocks;
    return unit;
}

} // namespace alcove
