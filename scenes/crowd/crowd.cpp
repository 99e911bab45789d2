#include "scenes/crowd/crowd.hpp"

#include "scenes/common/grid.hpp"
#include "scenes/common/knight.hpp"
#include "scenes/common/pedestal.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/split_mix.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <array>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

struct CrowdParameters {
    double detail = 1.0;
    int seed = 1;
};

ParameterTable make_table() {
    using P = CrowdParameters;
    return describe_parameters(
        "crowd", {real(&P::detail, "detail")
                      .range(1.0, 16.0)
                      .log_scale()
                      .unit("1")
                      .meaning("number of the knights' vertices, relative to the default")
                      .source("ours"),
                  integer(&P::seed, "seed")
                      .range(0, 65535)
                      .unit("1")
                      .meaning("chooses steps, folds of cloaks and speeds")
                      .source("ours")});
}

/// Of a knight of scene paladin, at detail 1: about 4,800 triangles.
constexpr double kKnightDetail = 0.04;
constexpr double kSink = 0.05;

struct Circle {
    int knights;
    int cycles; ///< of the gait around it: gives its radius
    bool is_leftward;
};
constexpr std::array<Circle, 2> kCircles{{{5, 15, true}, {7, 24, false}}};

constexpr std::array<KnightLook, 4> kLooks{{{{0.42f, 0.05f, 0.05f}, {0.16f, 0.2f, 0.42f}, 1},
                                            {{0.08f, 0.16f, 0.4f}, {0.6f, 0.52f, 0.2f}, 2},
                                            {{0.1f, 0.3f, 0.13f}, {0.5f, 0.48f, 0.44f}, 3},
                                            {{0.5f, 0.42f, 0.3f}, {0.35f, 0.1f, 0.12f}, 4}}};

std::vector<Mesh> make_square() {
    constexpr glm::vec3 kPaving(0.5f, 0.48f, 0.45f);
    constexpr glm::vec3 kWall(0.62f, 0.59f, 0.53f);
    std::vector<Mesh> meshes;
    meshes.push_back(make_box_mesh("square", kPaving, {-9.0, -0.3, -9.0}, {9.0, 0.0, 9.0}));
    meshes.push_back(make_pedestal("pedestal", kWall, 0.9, 0.75, 0.75, 6));
    MeshBuilder column;
    add_lathe(column,
              {{0.42, 0.86},
               {0.42, 0.95},
               {0.36, 1.0},
               {0.38, 1.06},
               {0.31, 1.12},
               {0.26, 3.6},
               {0.3, 3.64},
               {0.27, 3.68},
               {0.42, 3.9},
               {0.42, 4.0}},
              32);
    meshes.push_back(column.finish("column", kWall, 30.0));
    MeshBuilder walls;
    add_box(walls, {-8.5, -kSink, -8.6}, {8.5, 3.0, -8.0});
    add_box(walls, {-8.6, -0.04, -8.4}, {-8.0, 2.9, 8.4});
    for (int i = 0; i < 6; ++i) {
        const double at = -6.8 + 2.7 * i;
        add_box(walls, {at - 0.3, -0.06, -8.05}, {at + 0.3, 2.7, -7.7});
        add_box(walls, {-8.05, -0.07, at - 0.3}, {-7.7, 2.6, at + 0.3});
    }
    meshes.push_back(walls.finish("walls", kWall, 0.0));
    return meshes;
}

void add_knights(AnimatedSceneContent& content, KnightTroop& troop, int seed) {
    SplitMix random(static_cast<std::uint64_t>(seed) * 2 + 1);
    std::vector<std::size_t> looks;
    for (KnightLook look : kLooks) {
        look.seed += 16 * seed;
        looks.push_back(troop.add_look(content, look));
    }
    std::size_t first_node = 1;
    int number = 0;
    for (const Circle& circle : kCircles) {
        CircleWalk walk;
        walk.radius = circle.cycles * get_knight_body().cycle / (2.0 * std::numbers::pi);
        walk.is_leftward = circle.is_leftward;
        // One speed a circle: nobody catches up.
        walk.speed = random.draw(0.9, 1.1);
        for (int i = 0; i < circle.knights; ++i) {
            walk.start = 2.0 * std::numbers::pi * (i + random.draw(-0.1, 0.1)) / circle.knights;
            walk.phase = random.draw_unit();
            troop.add_knight(content, looks[static_cast<std::size_t>(number) % looks.size()], walk,
                             "knight " + std::to_string(number), first_node);
            first_node += KnightTroop::kNodes;
            ++number;
        }
    }
}

std::unique_ptr<Scene> open_crowd(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<CrowdParameters>(resolved);
    AnimatedSceneContent content;
    for (Mesh& mesh : make_square()) {
        AnimatedObject object;
        object.object = {mesh.name, content.meshes.size(), ObjectMotion::still};
        content.objects.push_back(std::move(object));
        content.meshes.push_back(std::move(mesh));
    }
    KnightTroop troop(kKnightDetail * parameters.detail);
    add_knights(content, troop, parameters.seed);
    content.nodes = [troop](double time_s) {
        std::vector<glm::dmat4> nodes{glm::dmat4(1.0)};
        troop.append_nodes(time_s, nodes);
        return nodes;
    };
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.5, 0.9, 0.6)), glm::vec3(0.95f, 0.9f, 0.8f)});
    content.lights.ambient = glm::vec3(0.46f, 0.49f, 0.54f);
    content.walkthrough = get_embedded_walkthrough("scenes/crowd/walkthrough.json");
    snap_cameras(content.walkthrough);
    content.ao_radius_m = 0.4;
    return std::make_unique<AnimatedScene>(std::move(content));
}

} // namespace

SceneUnit crowd_unit() {
    SceneUnit unit;
    unit.name = "crowd";
    unit.title = "Crowd of knights";
    unit.stresses = "many deforming bodies and cloaks at once, figures that cover and uncover each "
                    "other both ways, no still neighbourhood around what moves";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_crowd;
    return unit;
}

} // namespace alcove
