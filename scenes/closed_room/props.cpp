#include "scenes/closed_room/props.hpp"

#include "scenes/common/round_solids.hpp"
#include "scenes/common/solids.hpp"

#include <utility>

namespace alcove::closed_room {
namespace {

constexpr glm::vec3 kOak{0.5f, 0.36f, 0.22f};
constexpr glm::vec3 kPine{0.68f, 0.55f, 0.38f};

/// Four legs with square sections inside a rectangle, up into whatever stands on them.
void add_legs(MeshBuilder& builder, double half_x, double half_z, double height, double width) {
    for (const double x : {-half_x, half_x}) {
        for (const double z : {-half_z, half_z}) {
            add_box(builder, {x - 0.5 * width, -kSink, z - 0.5 * width},
                    {x + 0.5 * width, height, z + 0.5 * width});
        }
    }
}

Mesh make_shelf() {
    MeshBuilder builder;
    for (const double side : {-1.0, 1.0}) {
        add_box(builder, {side * 0.37 - 0.02, -kSink, -0.17}, {side * 0.37 + 0.02, 1.8, 0.17});
    }
    for (int i = 0; i < 5; ++i) {
        const double y = 0.08 + 0.42 * i;
        add_box(builder, {-0.36, y, -0.165}, {0.36, y + 0.03, 0.16});
    }
    add_box(builder, {-0.355, 0.02, -0.16}, {0.355, 1.77, -0.14});
    // Books on two boards, in falling sizes.
    for (int i = 0; i < 9; ++i) {
        const double x = -0.33 + 0.045 * i;
        add_box(builder, {x, 0.5, -0.12}, {x + 0.036, 0.74 + 0.012 * (i * 5 % 7), 0.06});
        add_box(builder, {-x - 0.036, 0.92, -0.12}, {-x, 1.16 + 0.012 * (i * 3 % 7), 0.05});
    }
    return builder.finish("shelf", kPine, 0.0);
}

Mesh make_chair() {
    MeshBuilder builder;
    add_legs(builder, 0.19, 0.19, 0.44, 0.04);
    add_box(builder, {-0.23, 0.42, -0.23}, {0.23, 0.47, 0.23});
    for (const double side : {-1.0, 1.0}) {
        add_box(builder, {side * 0.19 - 0.018, 0.45, -0.22}, {side * 0.19 + 0.018, 0.95, -0.18});
    }
    for (const double y : {0.6, 0.73, 0.86}) {
        add_box(builder, {-0.2, y, -0.212}, {0.2, y + 0.06, -0.19});
    }
    return builder.finish("chair", kOak, 0.0);
}

Mesh make_chest() {
    MeshBuilder builder;
    add_legs(builder, 0.33, 0.18, 0.12, 0.05);
    add_box(builder, {-0.38, 0.1, -0.22}, {0.38, 0.8, 0.2});
    add_box(builder, {-0.4, 0.78, -0.24}, {0.4, 0.82, 0.24});
    for (const double y : {0.14, 0.36, 0.58}) { // drawers and their knobs
        add_box(builder, {-0.35, y, 0.1}, {0.35, y + 0.18, 0.215});
        for (const double x : {-0.18, 0.18}) {
            add_box(builder, {x - 0.02, y + 0.07, 0.15}, {x + 0.02, y + 0.11, 0.24});
        }
    }
    return builder.finish("chest", {0.42f, 0.5f, 0.46f}, 0.0);
}

Mesh make_vase() {
    MeshBuilder builder;
    // Hollow: up its outside and down its inside.
    add_lathe(builder,
              {{0.0, -kSink},
               {0.13, -kSink},
               {0.14, 0.03},
               {0.2, 0.22},
               {0.21, 0.38},
               {0.15, 0.58},
               {0.09, 0.7},
               {0.09, 0.76},
               {0.13, 0.84},
               {0.11, 0.85},
               {0.07, 0.76},
               {0.07, 0.7},
               {0.12, 0.56},
               {0.17, 0.38},
               {0.16, 0.23},
               {0.1, 0.07},
               {0.0, 0.06}},
              40);
    return builder.finish("vase", {0.3f, 0.42f, 0.6f}, 60.0);
}

Mesh make_crates() {
    MeshBuilder builder;
    add_box(builder, {-0.36, -kSink, -0.24}, {0.06, 0.4, 0.22});
    add_box(builder, {0.09, -kSink, -0.2}, {0.38, 0.29, 0.24});
    add_box(builder, {-0.3, 0.38, -0.18}, {0.02, 0.68, 0.13});
    add_box(builder, {0.14, 0.27, -0.12}, {0.35, 0.5, 0.1});
    return builder.finish("crates", {0.6f, 0.48f, 0.3f}, 0.0);
}

Mesh make_bust() {
    MeshBuilder builder;
    add_box(builder, {-0.22, -kSink, -0.22}, {0.22, 0.1, 0.22});
    add_box(builder, {-0.17, 0.08, -0.17}, {0.17, 0.86, 0.17});
    add_box(builder, {-0.21, 0.84, -0.21}, {0.21, 0.92, 0.21});
    add_ball(builder, 3, [](const glm::dvec3& d) {
        return glm::dvec3(0.0, 1.03, 0.0) + glm::dvec3(0.2, 0.14, 0.13) * d; // shoulders
    });
    add_ball(builder, 3, [](const glm::dvec3& d) {
        return glm::dvec3(0.0, 1.34, 0.01) + glm::dvec3(0.1, 0.14, 0.12) * d; // head
    });
    add_tube(builder, {{0.0, 1.05, 0.0}, {0.0, 1.25, 0.005}}, {0.075, 0.06}, 20);
    return builder.finish("bust", glm::vec3(0.78f), 50.0);
}

Mesh make_lamp() {
    MeshBuilder builder;
    add_lathe(builder, {{0.17, -kSink}, {0.17, 0.02}, {0.03, 0.06}, {0.018, 0.1}, {0.018, 1.42}},
              32);
    // A shade that is open below and above.
    std::vector<Ring> rings;
    constexpr int kAround = 32;
    for (const auto& [radius, y] :
         {std::pair{0.24, 1.3}, {0.16, 1.62}, {0.152, 1.62}, {0.232, 1.3}}) {
        Contour circle = make_arc({0.0, 0.0}, {radius, radius}, 0.0, 6.283185307179586, kAround);
        circle.pop_back();
        Ring ring;
        for (const glm::dvec2& point : circle) {
            ring.emplace_back(point.x, y, -point.y);
        }
        rings.push_back(std::move(ring));
    }
    add_loft(builder, rings, LoftEnds::joined);
    add_box(builder, {-0.18, 1.36, -0.006}, {0.18, 1.374, 0.006}); // what holds the shade
    return builder.finish("lamp", {0.72f, 0.66f, 0.52f}, 40.0);
}

} // namespace

Mesh make_table() {
    MeshBuilder builder;
    add_legs(builder, 0.6, 0.3, 0.7, 0.07);
    add_box(builder, {-0.58, 0.6, -0.28}, {0.58, 0.69, 0.28});
    add_box(builder, {-0.7, 0.68, -0.4}, {0.7, 0.73, 0.4});
    add_lathe_at(builder, {0.25, 0.73, 0.05},
                 {{0.0, -kSink},
                  {0.07, -kSink},
                  {0.09, 0.02},
                  {0.16, 0.09},
                  {0.15, 0.1},
                  {0.08, 0.035},
                  {0.0, 0.025}},
                 32); // a bowl
    add_box(builder, {-0.45, 0.71, -0.15}, {-0.2, 0.77, 0.04});
    add_box(builder, {-0.43, 0.75, -0.12}, {-0.23, 0.8, 0.03});
    return builder.finish("table", kOak, 30.0);
}

std::vector<Mesh> make_props() {
    return {make_shelf(),  make_chair(), make_chest(), make_vase(),
            make_crates(), make_bust(),  make_lamp()};
}

} // namespace alcove::closed_room
