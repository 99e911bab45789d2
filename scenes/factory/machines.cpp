#include "scenes/common/round_solids.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/factory/elements.hpp"

#include <cmath>
#include <numbers>

namespace alcove::factory {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr glm::vec3 kGreen(0.3f, 0.42f, 0.36f);
constexpr glm::vec3 kSteel(0.58f, 0.59f, 0.6f);

/// A vertical vessel of 4.4 m on four legs with a ladder, a manhole and a pipe on top.
Mesh make_tank(const Fineness& fineness) {
    const int around = fineness.segments(28);
    MeshBuilder builder;
    Contour profile;
    const int arc = fineness.segments(5);
    for (int i = 0; i <= arc; ++i) {
        const double angle = 0.5 * kPi * i / arc;
        profile.emplace_back(i == 0 ? 0.0 : 1.1 * std::sin(angle), 1.1 - 0.45 * std::cos(angle));
    }
    for (int i = arc; i >= 0; --i) {
        const double angle = 0.5 * kPi * i / arc;
        profile.emplace_back(i == 0 ? 0.0 : 1.1 * std::sin(angle), 3.9 + 0.45 * std::cos(angle));
    }
    add_lathe(builder, profile, around);
    for (const double y : {1.3, 2.1, 2.9, 3.7}) { // bands
        add_lathe_at(builder, {0.0, y, 0.0},
                     {{1.0, -0.04}, {1.13, -0.04}, {1.14, 0.0}, {1.13, 0.04}, {1.0, 0.04}}, around);
    }
    for (int i = 0; i < 4; ++i) {
        const double angle = 0.5 * kPi * (i + 0.5);
        const glm::dvec3 foot(0.85 * std::cos(angle), 0.0, 0.85 * std::sin(angle));
        add_bar(builder, foot - glm::dvec3(0.0, kSink, 0.0), foot + glm::dvec3(0.0, 1.15, 0.0),
                0.08, fineness.segments(8));
        add_bar(builder, foot - glm::dvec3(0.0, kSink, 0.0), foot + glm::dvec3(0.0, 0.04, 0.0),
                0.16, fineness.segments(8));
    }
    // Ladder towards -z, the aisle, as seen from the vessels' side.
    const int rungs = fineness.count(11);
    for (const double x : {-0.22, 0.22}) {
        add_bar(builder, {x, 0.6, -1.3}, {x, 4.3, -1.3}, 0.022, 6);
        for (const double y : {1.3, 3.7}) {
            add_bar(builder, {x, y, -1.0}, {x, y, -1.31}, 0.018, 6);
        }
    }
    for (int i = 0; i < rungs; ++i) {
        const double y = 0.75 + 3.45 * i / (rungs - 1);
        add_bar(builder, {-0.22, y, -1.3}, {0.22, y, -1.3}, 0.014, 6);
    }
    add_bar(builder, {0.9, 2.5, -0.5}, {1.12, 2.5, -0.62}, 0.3, fineness.segments(16));
    add_pipe(builder, {{0.0, 0.75, 0.0}, {0.0, 0.35, 0.0}, {1.6, 0.35, 0.0}, {1.6, -kSink, 0.0}},
             0.1, 0.14, fineness);
    add_pipe(builder, {{0.0, 4.2, 0.0}, {0.0, 5.1, 0.0}, {0.0, 5.1, 2.2}}, 0.12, 0.3, fineness);
    return builder.finish("tank", kSteel, 50.0);
}

/// A horizontal vessel of 4 m on saddles, with a stack through the roof.
Mesh make_boiler(const Fineness& fineness) {
    const int around = fineness.segments(28);
    MeshBuilder builder;
    add_tube(builder,
             {{-1.95, 1.35, 0.0},
              {-1.9, 1.35, 0.0},
              {-1.7, 1.35, 0.0},
              {1.7, 1.35, 0.0},
              {1.9, 1.35, 0.0},
              {1.95, 1.35, 0.0}},
             {0.45, 0.75, 0.9, 0.9, 0.75, 0.45}, around);
    for (const double x : {-1.5, -0.5, 0.5, 1.5}) {
        add_bar(builder, {x - 0.05, 1.35, 0.0}, {x + 0.05, 1.35, 0.0}, 0.93, around);
    }
    for (const double x : {-1.1, 1.1}) {
        add_box(builder, {x - 0.15, -kSink, -0.75}, {x + 0.15, 0.8, 0.75});
        add_box(builder, {x - 0.25, -kSink, -0.85}, {x + 0.25, 0.1, 0.85});
    }
    add_lathe_at(builder, {0.9, 2.1, 0.0}, {{0.35, 0.0}, {0.3, 0.3}, {0.22, 0.6}, {0.22, 7.4}},
                 fineness.segments(14));
    add_bar(builder, {-2.06, 1.35, 0.0}, {-1.9, 1.35, 0.0}, 0.3, fineness.segments(16));
    for (int i = 0; i < 8; ++i) { // bolts
        const double angle = 0.25 * kPi * i;
        add_bar(builder, {-2.09, 1.35 + 0.25 * std::sin(angle), 0.25 * std::cos(angle)},
                {-2.0, 1.35 + 0.25 * std::sin(angle), 0.25 * std::cos(angle)}, 0.03, 6);
    }
    add_pipe(builder, {{-0.6, 2.15, 0.0}, {-0.6, 2.75, 0.0}, {-0.6, 2.75, 1.9}}, 0.08, 0.2,
             fineness);
    return builder.finish("boiler", {0.5f, 0.3f, 0.24f}, 50.0);
}

/// Motor with cooling rings, coupling and pump on one bed, along x.
Mesh make_pump(const Fineness& fineness) {
    const int around = fineness.segments(18);
    MeshBuilder builder;
    add_box(builder, {-1.1, -kSink, -0.4}, {1.1, 0.14, 0.4});
    add_box(builder, {-0.95, 0.12, -0.22}, {-0.1, 0.3, 0.22});
    add_box(builder, {0.35, 0.12, -0.18}, {0.75, 0.35, 0.18});
    add_bar(builder, {-1.0, 0.55, 0.0}, {-0.05, 0.55, 0.0}, 0.27, around);
    const int rings = fineness.count(9);
    for (int i = 0; i < rings; ++i) {
        const double x = -0.93 + 0.8 * i / rings;
        add_bar(builder, {x, 0.55, 0.0}, {x + 0.4 / rings, 0.55, 0.0}, 0.33, around);
    }
    add_bar(builder, {-0.15, 0.55, 0.0}, {0.5, 0.55, 0.0}, 0.06, fineness.segments(10));
    add_bar(builder, {0.08, 0.55, 0.0}, {0.2, 0.55, 0.0}, 0.14, around);
    add_tube(builder,
             {{0.35, 0.55, 0.0},
              {0.42, 0.55, 0.0},
              {0.5, 0.55, 0.0},
              {0.62, 0.55, 0.0},
              {0.7, 0.55, 0.0},
              {0.77, 0.55, 0.0}},
             {0.2, 0.34, 0.39, 0.39, 0.34, 0.2}, around);
    add_pipe(builder, {{0.56, 0.6, 0.2}, {0.56, 1.5, 0.2}, {0.56, 1.5, 1.4}}, 0.11, 0.26, fineness);
    return builder.finish("pump", {0.26f, 0.38f, 0.52f}, 50.0);
}

/// Four columns between bed and head, a ram, and a control box on an arm.
Mesh make_press(const Fineness& fineness) {
    const int around = fineness.segments(12);
    MeshBuilder builder;
    add_box(builder, {-0.9, -kSink, -0.7}, {0.9, 0.7, 0.7});
    add_box(builder, {-0.75, 0.68, -0.55}, {0.75, 0.8, 0.55});
    add_box(builder, {-0.95, 2.0, -0.75}, {0.95, 2.55, 0.75});
    for (const double x : {-0.72, 0.72}) {
        for (const double z : {-0.52, 0.52}) {
            add_bar(builder, {x, 0.6, z}, {x, 2.65, z}, 0.09, around);
            add_bar(builder, {x, 2.5, z}, {x, 2.72, z}, 0.14, 6);
        }
    }
    add_bar(builder, {0.0, 1.5, 0.0}, {0.0, 2.1, 0.0}, 0.2, around);
    add_box(builder, {-0.5, 1.4, -0.4}, {0.5, 1.52, 0.4});
    add_bar(builder, {0.0, 2.5, 0.0}, {0.0, 2.76, 0.0}, 0.35, fineness.segments(20));
    add_box(builder, {1.1, 1.1, -0.5}, {1.4, 1.6, -0.15});
    add_box(builder, {0.85, 1.3, -0.36}, {1.15, 1.4, -0.28});
    add_box(builder, {0.85, 1.29, -0.37}, {0.93, 2.1, -0.27});
    for (int i = 0; i < fineness.count(4); ++i) { // slots of the bed
        const double x = -0.6 + 1.2 * (i + 0.5) / fineness.count(4);
        add_box(builder, {x - 0.03, 0.78, -0.5}, {x + 0.03, 0.83, 0.5});
    }
    return builder.finish("press", kGreen, 40.0);
}

Mesh make_barrel(const Fineness& fineness) {
    MeshBuilder builder;
    add_lathe(builder,
              {{0.0, -kSink},
               {0.29, -kSink},
               {0.3, 0.03},
               {0.285, 0.05},
               {0.285, 0.28},
               {0.3, 0.3},
               {0.285, 0.32},
               {0.285, 0.56},
               {0.3, 0.58},
               {0.285, 0.6},
               {0.285, 0.84},
               {0.3, 0.86},
               {0.29, 0.88},
               {0.27, 0.87},
               {0.26, 0.85},
               {0.0, 0.85}},
              fineness.segments(16));
    return builder.finish("barrel", {0.2f, 0.3f, 0.48f}, 60.0);
}

Mesh make_cabinet(const Fineness& fineness) {
    MeshBuilder builder;
    add_box(builder, {-0.9, -kSink, -0.3}, {0.9, 0.1, 0.28});
    add_box(builder, {-0.88, 0.08, -0.29}, {0.88, 2.0, 0.29});
    for (int door = 0; door < 3; ++door) {
        const double x = -0.58 + 0.58 * door;
        add_box(builder, {x - 0.27, 0.15, -0.32}, {x + 0.27, 1.94, -0.27});
        add_box(builder, {x + 0.17, 1.0, -0.37}, {x + 0.2, 1.15, -0.3});
        const int slots = fineness.count(6);
        for (int i = 0; i < slots; ++i) {
            const double y = 0.3 + 0.42 * i / slots;
            add_box(builder, {x - 0.2, y, -0.335}, {x + 0.2, y + 0.2 / slots, -0.3});
        }
    }
    return builder.finish("cabinet", {0.55f, 0.57f, 0.52f}, 0.0);
}

} // namespace

void add_machines(SceneKit& kit, const Fineness& fineness) {
    const std::size_t tank = kit.add_mesh(make_tank(fineness));
    for (const double x : {-10.6, -5.6, 9.4}) {
        kit.place(tank, make_place({x, 0.0, 3.7}));
    }
    const std::size_t boiler = kit.add_mesh(make_boiler(fineness));
    kit.place(boiler, make_place({-0.2, 0.0, 3.6}));
    kit.place(boiler, make_place({5.0, 0.0, 3.6}));
    const std::size_t press = kit.add_mesh(make_press(fineness));
    for (const double x : {-7.4, -2.4, 7.8}) {
        kit.place(press, make_place({x, 0.0, -4.4}, kPi));
    }
    const std::size_t pump = kit.add_mesh(make_pump(fineness));
    for (const double x : {-12.4, -5.3, -0.3, 3.4, 9.8}) {
        kit.place(pump, make_place({x, 0.0, -4.0}, kPi));
    }
    const std::size_t barrel = kit.add_mesh(make_barrel(fineness));
    for (int i = 0; i < 7; ++i) {
        kit.place(barrel,
                  make_place({-8.5 + 0.64 * (i % 4) + 0.3 * (i / 4), 0.0, 2.35 + 0.58 * (i / 4)},
                             0.7 * i));
    }
    const std::size_t cabinet = kit.add_mesh(make_cabinet(fineness));
    for (const double x : {2.35, 7.3}) {
        kit.place(cabinet, make_place({x, 0.0, 2.6 + 0.02 * x}));
    }
}

void add_moving_parts(SceneKit& kit, const Fineness& fineness) {
    // The crane runs on the rails above everything; its hook hangs beside the aisle.
    MeshBuilder crane;
    const double reach = kHalfWidth - 0.75;
    for (const double x : {-0.5, 0.5}) {
        add_box(crane, {x - 0.15, 6.85, -reach}, {x + 0.15, 7.35, reach});
    }
    for (const double side : {-1.0, 1.0}) {
        const double z = side * reach;
        add_box(crane, {-0.9, 6.78, z - 0.13}, {0.9, 7.1, z + 0.13});
        for (const double x : {-0.65, 0.65}) {
            add_bar(crane, {x, 6.82, z - 0.06}, {x, 6.82, z + 0.06}, 0.115, fineness.segments(16));
        }
    }
    add_box(crane, {-0.75, 7.3, -1.1}, {0.75, 7.5, 0.1});
    add_bar(crane, {-0.45, 7.62, -0.5}, {0.45, 7.62, -0.5}, 0.2, fineness.segments(16));
    add_box(crane, {0.3, 7.45, -0.85}, {0.6, 7.8, -0.2});
    for (const double x : {-0.06, 0.06}) {
        add_bar(crane, {x, 4.7, -0.5}, {x, 7.6, -0.5}, 0.012, 6);
    }
    add_box(crane, {-0.16, 4.4, -0.57}, {0.16, 4.75, -0.43});
    add_ring(crane, {0.0, 4.2, -0.5}, 0.14, 0.035, fineness);
    kit.add(crane.finish("crane", {0.72f, 0.56f, 0.1f}, 40.0));

    // A flywheel between two bearings at the aisle; its axle lies along z.
    MeshBuilder bearings;
    for (const double z : {-2.55, -1.95}) {
        add_box(bearings, {-0.3, -kSink, z - 0.12}, {0.3, 0.16, z + 0.12});
        add_box(bearings, {-0.16, 0.1, z - 0.09}, {0.16, 1.1, z + 0.09});
        add_bar(bearings, {0.0, 1.1, z - 0.11}, {0.0, 1.1, z + 0.11}, 0.2, fineness.segments(14));
    }
    kit.add(bearings.finish("bearings", kGreen, 40.0), make_place({2.2, 0.0, 0.0}));
    MeshBuilder wheel;
    add_ring(wheel, glm::dvec3(0.0), 0.92, 0.09, fineness);
    add_bar(wheel, {0.0, 0.0, -0.5}, {0.0, 0.0, 0.5}, 0.07, fineness.segments(10));
    add_bar(wheel, {0.0, 0.0, -0.12}, {0.0, 0.0, 0.12}, 0.17, fineness.segments(14));
    constexpr int kSpokes = 6;
    for (int i = 0; i < kSpokes; ++i) {
        const double angle = 2.0 * kPi * i / kSpokes;
        const glm::dvec3 out(std::cos(angle), std::sin(angle), 0.0);
        add_bar(wheel, 0.08 * out, 0.92 * out, 0.05, fineness.segments(8));
    }
    const int teeth = fineness.count(24);
    for (int i = 0; i < teeth; ++i) {
        const double angle = 2.0 * kPi * i / teeth;
        const glm::dvec3 out(std::cos(angle), std::sin(angle), 0.0);
        add_tube(wheel, {0.95 * out, 1.06 * out}, {0.05, 0.03}, 4);
    }
    kit.add(wheel.finish("flywheel", {0.5f, 0.2f, 0.16f}, 50.0), make_place({2.2, 1.1, -2.25}));
}

} // namespace alcove::factory
