#include "scenes/paladin/paladin.hpp"

#include "scenes/common/grid.hpp"
#include "scenes/common/knight.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

enum class Path { standard, walk };

struct PaladinParameters {
    double detail = 1.0;
    int seed = 1;
    Path walkthrough = Path::standard;
};

ParameterTable make_table() {
    using P = PaladinParameters;
    return describe_parameters(
        "paladin",
        {real(&P::detail, "detail")
             .range(0.06, 16.0)
             .log_scale()
             .unit("1")
             .meaning("number of the knight's vertices, relative to the default")
             .source("ours"),
         integer(&P::seed, "seed")
             .range(0, 65535)
             .unit("1")
             .meaning("chooses where the cloak's folds lie and how it waves")
             .source("ours"),
         choice(&P::walkthrough, "walkthrough", {"default", "walk"})
             .meaning("the cloak from near in 120 frames, or 300 frames of the whole figure")
             .source("ours")});
}

/// Solids that meet reach into each other by this, metres: no two faces share a plane.
constexpr double kSink = 0.05;
/// Once around are this many cycles of the gait, a multiple of Cloak::kRepeat: the walk repeats.
constexpr int kCycles = 12;
static_assert(kCycles % Cloak::kRepeat == 0);

CircleWalk make_walk() {
    CircleWalk walk;
    walk.radius = kCycles * get_knight_body().cycle / (2.0 * std::numbers::pi);
    walk.speed = 1.0;
    return walk;
}

/// A corner of two walls, a pillar in the middle of the circle, steps, a bench and a step of
/// stones.
std::vector<Mesh> make_yard() {
    constexpr glm::vec3 kFloor(0.5f, 0.48f, 0.45f);
    constexpr glm::vec3 kWall(0.66f, 0.63f, 0.57f);
    constexpr glm::vec3 kStone(0.58f, 0.55f, 0.5f);
    constexpr glm::vec3 kWood(0.36f, 0.25f, 0.16f);
    std::vector<Mesh> meshes;
    meshes.push_back(make_box_mesh("floor", kFloor, {-7.0, -0.3, -7.0}, {7.0, 0.0, 7.0}));
    meshes.push_back(make_box_mesh("north wall", kWall, {-6.0, -kSink, -5.6}, {6.0, 4.2, -5.0}));
    meshes.push_back(make_box_mesh("west wall", kWall, {-5.6, -kSink, -5.3}, {-5.0, 4.1, 5.5}));
    const auto add = [&meshes](const MeshBuilder& builder, const char* name,
                               const glm::vec3& albedo, double crease) {
        meshes.push_back(builder.finish(name, albedo, crease));
    };
    MeshBuilder pillar;
    add_lathe(pillar,
              {{0.5, -kSink},
               {0.5, 0.12},
               {0.44, 0.16},
               {0.47, 0.22},
               {0.47, 0.27},
               {0.4, 0.33},
               {0.34, 0.37},
               {0.3, 2.9},
               {0.34, 2.93},
               {0.34, 2.99},
               {0.31, 3.02},
               {0.45, 3.2},
               {0.5, 3.22},
               {0.5, 3.4}},
              48);
    add(pillar, "pillar", kStone, 30.0);
    MeshBuilder steps; // up to the west wall
    constexpr int kSteps = 4;
    for (int i = 0; i < kSteps; ++i) {
        add_box(steps, {-5.0 - kSink, -kSink + 0.01 * i, -2.6 + 0.02 * i},
                {-3.7 - 0.3 * i, 0.17 * (i + 1), 0.6 - 0.02 * i});
    }
    add(steps, "steps", kStone, 0.0);
    MeshBuilder string_course;
    add_box(string_course, {-5.0 - kSink, 1.9, -5.1}, {-4.93, 2.04, 5.45});
    add_box(string_course, {-5.06, 1.905, -5.0 - kSink}, {5.95, 2.035, -4.92});
    add(string_course, "string course", kStone, 0.0);
    MeshBuilder piers;
    for (int i = 0; i < 4; ++i) {
        const double x = -3.6 + 2.9 * i;
        add_box(piers, {x - 0.25, -kSink, -5.0 - kSink}, {x + 0.25, 3.6, -4.72});
        add_box(piers, {x - 0.31, -kSink, -5.0 - kSink}, {x + 0.31, 0.45, -4.65});
    }
    add(piers, "piers", kWall, 0.0);
    MeshBuilder bench;
    add_box(bench, {-1.9, 0.4, -4.5}, {0.7, 0.46, -4.05});
    for (const double x : {-1.7, 0.4}) {
        add_box(bench, {x, -kSink, -4.46}, {x + 0.1, 0.43, -4.09});
    }
    add(bench, "bench", kWood, 0.0);
    MeshBuilder barrel;
    add_lathe_at(barrel, {2.4, 0.0, -4.1},
                 {{0.27, -kSink},
                  {0.27, 0.03},
                  {0.32, 0.25},
                  {0.34, 0.45},
                  {0.32, 0.65},
                  {0.27, 0.88},
                  {0.24, 0.88},
                  {0.24, 0.84}},
                 36);
    add(barrel, "barrel", kWood, 30.0);
    return meshes;
}

std::unique_ptr<Scene> open_paladin(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<PaladinParameters>(resolved);
    AnimatedSceneContent content;
    for (Mesh& mesh : make_yard()) {
        AnimatedObject object;
        object.object = {mesh.name, content.meshes.size(), ObjectMotion::still};
        content.objects.push_back(std::move(object));
        content.meshes.push_back(std::move(mesh));
    }
    KnightTroop troop(parameters.detail);
    KnightLook look;
    look.seed = parameters.seed;
    const std::size_t number = troop.add_look(content, look);
    troop.add_knight(content, number, make_walk(), "paladin", 1);
    content.nodes = [troop](double time_s) {
        std::vector<glm::dmat4> nodes{glm::dmat4(1.0)};
        troop.append_nodes(time_s, nodes);
        return nodes;
    };
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.5, 0.9, 0.55)), glm::vec3(0.95f, 0.9f, 0.8f)});
    content.lights.ambient = glm::vec3(0.46f, 0.49f, 0.54f);
    content.walkthrough = get_embedded_walkthrough(parameters.walkthrough == Path::standard
                                                       ? "scenes/paladin/walkthrough.json"
                                                       : "scenes/paladin/walkthrough_walk.json");
    snap_cameras(content.walkthrough);
    content.ao_radius_m = 0.4;
    return std::make_unique<AnimatedScene>(std::move(content));
}

} // namespace

SceneUnit paladin_unit() {
    SceneUnit unit;
    unit.name = "paladin";
    unit.title = "Paladin with a cloak";
    unit.stresses = "a deforming cloak whose every pixel changes its surroundings, skinned limbs, "
                    "thin closed cloth before a body, feet that lift off their contact";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_paladin;
    return unit;
}

} // namespace alcove
