#include "scenes/pebbles/pebbles.hpp"

#include "scenes/common/round_solids.hpp"
#include "scenes/common/scene_kit.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/split_mix.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

struct PebblesParameters {
    int count = 350;
    double height_m = 0.03;
    int seed = 1;
};

constexpr double kHalfField = 1.2; ///< pebbles lie in a square of twice this side, metres
constexpr std::size_t kShapes = 6;

ParameterTable make_table() {
    using P = PebblesParameters;
    return describe_parameters(
        "pebbles",
        {integer(&P::count, "count")
             .range(10, 2000)
             .log_scale()
             .unit("1")
             .meaning("pebbles on 2.4 m by 2.4 m; with more they are smaller, so that they cover "
                      "as much")
             .source("ours"),
         real(&P::height_m, "height")
             .range(0.001, 0.1)
             .log_scale()
             .unit("m")
             .meaning("of the middle pebble's top above the plane; others from 0.6 to 1.4 times "
                      "as high")
             .source("ours"),
         integer(&P::seed, "seed")
             .range(0, 65535)
             .unit("1")
             .meaning("chooses shapes, sizes, places and shades")
             .source("ours")});
}

/// Rounded by water: a ball with three broad dents and bumps, about 1 in radius.
Mesh make_pebble(std::size_t number, SplitMix& random) {
    std::array<glm::dvec3, 3> ways{};
    std::array<double, 3> depths{};
    for (std::size_t i = 0; i < ways.size(); ++i) {
        ways[i] = glm::normalize(
            glm::dvec3(random.draw(-1.0, 1.0), random.draw(-0.6, 0.6), random.draw(-1.0, 1.0)));
        depths[i] = random.draw(-0.18, 0.12);
    }
    MeshBuilder builder;
    add_ball(builder, 2, [&](const glm::dvec3& direction) {
        double radius = 1.0;
        for (std::size_t i = 0; i < ways.size(); ++i) {
            const double facing = std::max(0.0, glm::dot(direction, ways[i]));
            radius += depths[i] * facing * facing;
        }
        return radius * direction;
    });
    const auto shade = static_cast<float>(random.draw(0.35, 0.7));
    const auto warmth = static_cast<float>(random.draw(-0.05, 0.05));
    return builder.finish("pebble " + std::to_string(number),
                          {shade + warmth, shade, shade - warmth}, 180.0);
}

struct Pebble {
    glm::dvec2 place{0.0};
    double radius = 0.0; ///< as it is seen from above
};

/// By throwing darts: none overlaps another. With the gaps between them they fill a third of the
/// field; random darts find no place any more at 0.547 (E. Hinrichsen, J. Feder, T. Jossang.
/// Geometry of Random Sequential Adsorption. 1986).
std::vector<Pebble> scatter(int count, SplitMix& random) {
    const double middle = kHalfField * std::sqrt(4.0 * 0.3 / (std::numbers::pi * count));
    std::vector<Pebble> pebbles;
    while (pebbles.size() < static_cast<std::size_t>(count)) {
        Pebble pebble;
        pebble.radius = middle * random.draw(0.6, 1.25);
        pebble.place = {random.draw(-kHalfField, kHalfField), random.draw(-kHalfField, kHalfField)};
        const bool is_free = std::none_of(pebbles.begin(), pebbles.end(), [&](const Pebble& other) {
            return glm::distance(other.place, pebble.place) < 1.12 * (other.radius + pebble.radius);
        });
        if (is_free) {
            pebbles.push_back(pebble);
        }
    }
    return pebbles;
}

std::unique_ptr<Scene> open_pebbles(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<PebblesParameters>(resolved);
    SplitMix random(static_cast<std::uint64_t>(parameters.seed) * 2 + 1);
    SceneKit kit;
    kit.add(make_box_mesh("plane", {0.62f, 0.6f, 0.56f}, {-3.0, -0.3, -3.0}, {3.0, 0.0, 3.0}));
    std::array<std::size_t, kShapes> shapes{};
    for (std::size_t i = 0; i < kShapes; ++i) {
        shapes[i] = kit.add_mesh(make_pebble(i, random));
    }
    for (const Pebble& pebble : scatter(parameters.count, random)) {
        // A quarter of its height lies below the plane.
        const double top = parameters.height_m * random.draw(0.6, 1.4);
        const double half = top / 1.5;
        const double wide = pebble.radius * random.draw(0.95, 1.1);
        kit.place(shapes[static_cast<std::size_t>(random.draw_index(static_cast<int>(kShapes)))],
                  make_place({pebble.place.x, 0.5 * half, pebble.place.y},
                             random.draw(0.0, 2.0 * std::numbers::pi),
                             {wide, half, pebble.radius * random.draw(0.7, 0.95)}));
    }
    RigidSceneContent content = kit.take();
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(-0.8, 0.8, 0.2)), glm::vec3(1.0f, 0.96f, 0.9f)});
    content.lights.ambient = glm::vec3(0.4f, 0.44f, 0.5f);
    content.walkthrough = get_embedded_walkthrough("scenes/pebbles/walkthrough.json");
    content.ao_radius_m = 0.1;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit pebbles_unit() {
    SceneUnit unit;
    unit.name = "pebbles";
    unit.title = "Pebbles on a plane";
    unit.stresses = "occluders that are small against radius and distance: biases that swallow "
                    "them, few samples that miss them, blurs that wash them out";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_pebbles;
    return unit;
}

} // namespace alcove
