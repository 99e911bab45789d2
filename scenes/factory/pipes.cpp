#include "scenes/common/round_solids.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/factory/elements.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace alcove::factory {
namespace {

constexpr std::array<glm::vec3, 4> kPaints{
    {{0.62f, 0.62f, 0.6f}, {0.25f, 0.42f, 0.56f}, {0.66f, 0.52f, 0.16f}, {0.34f, 0.5f, 0.36f}}};

/// Pipes along the wall in four heights, each with its own bends: down, around a machine, up.
Mesh make_run(int number, double side, const Fineness& fineness) {
    const double radius = 0.16 - 0.025 * number;
    const double z = side * (kHalfWidth - 1.1 - 0.42 * number);
    const double y = 3.5 + 0.34 * number;
    const double first = -9.0 + 4.2 * number;
    const double low = 0.8 + 0.25 * number;
    MeshBuilder builder;
    add_pipe(builder,
             {{-kHalfLength - 0.1, y, z},
              {first, y, z},
              {first, low, z},
              {first + 2.4, low, z},
              {first + 2.4, y + 0.1, z},
              {kHalfLength + 0.1, y + 0.1, z}},
             radius, 2.2 * radius, fineness);
    // Joints along the way, and rods that hang them from the trusses.
    constexpr int kJoints = 6;
    for (int i = 0; i < kJoints; ++i) {
        const double x = -13.2 + 5.0 * i + 0.3 * number;
        const double height = x < first ? y : y + 0.1;
        if (x > first - 0.8 && x < first + 3.2) {
            continue;
        }
        add_bar(builder, {x - 0.06, height, z}, {x + 0.06, height, z}, 1.45 * radius,
                fineness.segments(10));
        add_bar(builder, {x + 0.25, height, z}, {x + 0.25, kEaves - 0.1, z}, 0.015, 6);
    }
    return builder.finish("pipe", kPaints.at(static_cast<std::size_t>(number)), 50.0);
}

/// A wheel on a spindle, as on every drop.
Mesh make_valve(const Fineness& fineness) {
    MeshBuilder builder;
    add_lathe(builder,
              {{0.0, -0.24},
               {0.14, -0.2},
               {0.19, -0.08},
               {0.2, 0.0},
               {0.19, 0.08},
               {0.14, 0.2},
               {0.0, 0.24}},
              fineness.segments(14));
    add_bar(builder, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.5}, 0.035, fineness.segments(8));
    add_ring(builder, {0.0, 0.0, 0.46}, 0.2, 0.022, fineness);
    for (int i = 0; i < 4; ++i) {
        const double angle = 0.5 * std::numbers::pi * i + 0.3;
        const glm::dvec3 out(std::cos(angle), std::sin(angle), 0.0);
        const glm::dvec3 hub(0.0, 0.0, 0.46);
        add_bar(builder, hub + 0.02 * out, hub + 0.2 * out, 0.015, 6);
    }
    return builder.finish("valve", {0.62f, 0.16f, 0.12f}, 50.0);
}

/// A duct with square section below the roof, with outlets.
Mesh make_duct(const Fineness& fineness) {
    MeshBuilder builder;
    add_box(builder, {-kHalfLength - 0.08, 6.95, 2.6}, {kHalfLength + 0.08, 7.6, 3.4});
    const int collars = fineness.count(18);
    for (int i = 0; i < collars; ++i) {
        const double x = -kHalfLength + 0.6 + (2.0 * kHalfLength - 1.2) * i / (collars - 1);
        add_box(builder, {x - 0.03, 6.91, 2.56}, {x + 0.03, 7.64, 3.44});
    }
    for (int i = 0; i < 5; ++i) {
        const double x = -11.6 + 5.0 * i;
        add_lathe_at(builder, {x, 6.4, 3.0}, {{0.42, 0.0}, {0.42, 0.05}, {0.24, 0.35}, {0.24, 0.6}},
                     fineness.segments(16));
    }
    return builder.finish("duct", glm::vec3(0.66f), 30.0);
}

} // namespace

void add_pipes(SceneKit& kit, const Fineness& fineness) {
    const std::size_t valve = kit.add_mesh(make_valve(fineness));
    for (int number = 0; number < 4; ++number) {
        for (const double side : {-1.0, 1.0}) {
            const std::size_t run = kit.add_mesh(make_run(number, side, fineness));
            kit.place(run, make_place({0.0, 0.0, 0.0}));
            const double z = side * (kHalfWidth - 1.1 - 0.42 * number);
            const double x = -9.0 + 4.2 * number + 2.4;
            kit.place(valve, make_place({x, 2.1, z}, side > 0.0 ? std::numbers::pi : 0.0));
        }
    }
    kit.add(make_duct(fineness));
}

} // namespace alcove::factory
