#include "scenes/pillars_in_a_row/pillars_in_a_row.hpp"

#include "scenes/common/scene_kit.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

enum class Path { along, sideways };

struct PillarsParameters {
    int count = 12;
    double spacing_m = 0.8;
    double diameter_m = 0.4;
    Path walkthrough = Path::along;
};

constexpr double kHeight = 3.0; ///< of the beam's lower side
/// Solids that meet reach this deep into each other, metres: no two faces in one plane.
constexpr double kSink = 0.05;

ParameterTable make_table() {
    using P = PillarsParameters;
    return describe_parameters(
        "pillars_in_a_row",
        {integer(&P::count, "count").range(2, 64).unit("1").meaning("pillars").source("ours"),
         real(&P::spacing_m, "spacing")
             .range(0.1, 5.0)
             .log_scale()
             .unit("m")
             .meaning("free space between the shafts of two neighbours")
             .source("ours"),
         real(&P::diameter_m, "diameter")
             .range(0.02, 1.5)
             .log_scale()
             .unit("m")
             .meaning("of a shaft above its base")
             .source("ours"),
         choice(&P::walkthrough, "walkthrough", {"along", "sideways"})
             .meaning("a slow dolly beside the row that looks along it, or one that faces it")
             .source("ours")});
}

Mesh make_pillar(double diameter_m, double overhang_m) {
    const double r = 0.5 * diameter_m;
    const double wide = r + overhang_m;
    const double step = std::min(0.12, 0.3 * diameter_m); // height of base and capital
    MeshBuilder builder;
    constexpr double kTop = kHeight + kSink;
    // Shaft with base and capital in one turn; it narrows towards the top by a tenth.
    add_lathe(builder,
              {{wide, -kSink},
               {wide, step},
               {r + 0.4 * overhang_m, 1.3 * step},
               {r, 1.8 * step},
               {r, 1.0},
               {0.96 * r, 2.0},
               {0.9 * r, kHeight - 2.2 * step},
               {r + 0.2 * overhang_m, kHeight - 2.0 * step},
               {0.9 * r, kHeight - 1.8 * step},
               {wide, kHeight - step},
               {wide, kTop}},
              32);
    return builder.finish("pillar", {0.72f, 0.68f, 0.6f}, 40.0);
}

std::unique_ptr<Scene> open_pillars(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<PillarsParameters>(resolved);
    const double pitch = parameters.spacing_m + parameters.diameter_m;
    const double end = pitch * (parameters.count - 1);
    const double overhang = std::min(0.25 * parameters.diameter_m, 0.3 * parameters.spacing_m);
    const double half_beam = 0.5 * parameters.diameter_m + overhang + 0.06;
    const double wall = -half_beam - 1.6; // z of its face
    // The floor reaches behind the camera, which starts before the row.
    const double low = -5.0;
    const double high = end + 5.0;
    SceneKit kit;
    kit.add(make_box_mesh("floor", glm::vec3(0.6f), {low, -0.3, wall - 0.4}, {high, 0.0, 7.0}));
    kit.add(make_box_mesh("wall", {0.55f, 0.6f, 0.66f}, {low + 0.1, -kSink, wall - 0.3},
                          {high - 0.1, kHeight + 1.2, wall}));
    kit.add(make_box_mesh("beam", {0.66f, 0.62f, 0.55f}, {-half_beam - 0.4, kHeight, -half_beam},
                          {end + half_beam + 0.4, kHeight + 0.45, half_beam}));
    kit.add(make_box_mesh("cornice", {0.7f, 0.66f, 0.58f},
                          {-half_beam - 0.55, kHeight + 0.4, -half_beam - 0.15},
                          {end + half_beam + 0.55, kHeight + 0.6, half_beam + 0.15}));
    const std::size_t pillar = kit.add_mesh(make_pillar(parameters.diameter_m, overhang));
    for (int i = 0; i < parameters.count; ++i) {
        kit.place(pillar, make_place({pitch * i, 0.0, 0.0}));
    }
    RigidSceneContent content = kit.take();
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(-0.5, 1.0, 0.8)), glm::vec3(0.9f, 0.86f, 0.8f)});
    content.lights.ambient = glm::vec3(0.46f, 0.48f, 0.52f);
    content.walkthrough =
        get_embedded_walkthrough(parameters.walkthrough == Path::along
                                     ? "scenes/pillars_in_a_row/walkthrough.json"
                                     : "scenes/pillars_in_a_row/walkthrough_sideways.json");
    content.ao_radius_m = 0.5;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit pillars_in_a_row_unit() {
    SceneUnit unit;
    unit.name = "pillars_in_a_row";
    unit.title = "Row of pillars before a wall";
    unit.stresses = "depth edges in a row, down to less than a pixel: flicker of downsampled or "
                    "layered depth under a slow camera, halos on the wall behind";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_pillars;
    return unit;
}

} // namespace alcove
