#include "scenes/twisted_columns/twisted_columns.hpp"

#include "scenes/common/scene_kit.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr double kPi = std::numbers::pi;
/// Solids that meet reach this deep into each other, metres: no two faces in one plane.
constexpr double kSink = 0.02;

struct TwistedColumnsParameters {
    double turns = 1.5;
};

ParameterTable make_table() {
    return describe_parameters("twisted_columns",
                               {real(&TwistedColumnsParameters::turns, "turns")
                                    .range(0.0, 4.0)
                                    .unit("1")
                                    .meaning("of a shaft from its base to its capital")
                                    .source("ours; Ritschel, Grosch and Seidel 2009, figure 7")});
}

/// Of a column whose widest place, its plinth, reaches 1.45 times `radius` to each side; a shaft of
/// `strands` round strands that lie within `radius`.
struct Shape {
    double radius = 0.2;
    double height = 2.0;
    int strands = 3;
    double turns = 1.5;
};

Mesh make_column(const char* name, const glm::vec3& albedo, const Shape& shape) {
    constexpr int kAround = 48;
    constexpr int kRows = 72;
    const double r = shape.radius;
    const double foot = 0.7 * r;
    const double head = shape.height - 0.7 * r;
    MeshBuilder builder;
    std::vector<Ring> rings;
    for (int row = 0; row <= kRows; ++row) {
        const double along = static_cast<double>(row) / kRows;
        const double y = foot - kSink + along * (head - foot + 2.0 * kSink);
        Ring ring;
        for (int i = 0; i < kAround; ++i) {
            const double angle = 2.0 * kPi * i / kAround;
            const double lobe =
                std::cos(0.5 * shape.strands * (angle - 2.0 * kPi * shape.turns * along));
            const double reach = r * (0.62 + 0.38 * std::abs(lobe));
            ring.emplace_back(reach * std::cos(angle), y, -reach * std::sin(angle));
        }
        rings.push_back(std::move(ring));
    }
    add_loft(builder, rings, LoftEnds::capped);
    add_box(builder, {-1.45 * r, -kSink, -1.45 * r}, {1.45 * r, 0.35 * r, 1.45 * r});
    add_lathe(builder,
              {{1.35 * r, 0.35 * r - kSink},
               {1.35 * r, 0.45 * r},
               {1.2 * r, 0.55 * r},
               {1.12 * r, 0.62 * r},
               {1.12 * r, foot}},
              40);
    add_lathe(builder,
              {{1.05 * r, head},
               {1.12 * r, head + 0.1 * r},
               {1.1 * r, head + 0.18 * r},
               {1.35 * r, head + 0.4 * r}},
              40);
    add_box(builder, {-1.44 * r, shape.height - 0.35 * r, -1.44 * r},
            {1.44 * r, shape.height, 1.44 * r});
    return builder.finish(name, albedo, 50.0);
}

std::unique_ptr<Scene> open_twisted_columns(const ResolvedParameters& resolved) {
    const double turns = make_table().bind<TwistedColumnsParameters>(resolved).turns;
    constexpr glm::vec3 kWhite(0.78f);
    constexpr glm::vec3 kPink(0.85f, 0.28f, 0.45f);
    SceneKit kit;
    kit.add(make_box_mesh("floor", glm::vec3(0.72f), {-3.0, -0.3, -2.2}, {3.0, 0.0, 4.5}));
    kit.add(make_box_mesh("wall", glm::vec3(0.7f), {-2.9, -0.05, -2.0}, {2.9, 3.0, -1.5}));
    // On the first frames the camera, the white and the pink column stand in line; the pink one is
    // thinner, lower and farther, and light from it reaches the floor beside it and the wall.
    kit.add(make_column("white", kWhite, {0.3, 2.1, 3, turns}));
    kit.add(make_column("pink", kPink, {0.12, 1.5, 2, -turns}), make_place({0.0, 0.0, -1.0}));
    kit.add(make_column("left", kWhite, {0.2, 1.9, 4, -turns}),
            make_place({-1.15, 0.0, -0.45}, 0.2));
    kit.add(make_column("right", kWhite, {0.2, 1.6, 2, turns}),
            make_place({1.1, 0.0, -0.65}, -0.3));
    RigidSceneContent content = kit.take();
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.7, 1.0, 0.35)), glm::vec3(1.0f, 0.97f, 0.92f)});
    content.lights.ambient = glm::vec3(0.44f, 0.46f, 0.5f);
    content.walkthrough = get_embedded_walkthrough("scenes/twisted_columns/walkthrough.json");
    content.ao_radius_m = 0.4;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit twisted_columns_unit() {
    SceneUnit unit;
    unit.name = "twisted_columns";
    unit.title = "Twisted columns, one hidden";
    unit.stresses = "an occluder and sender of colour that the camera does not see, until it goes "
                    "aside; grooves that wind about a shaft";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_twisted_columns;
    return unit;
}

} // namespace alcove
