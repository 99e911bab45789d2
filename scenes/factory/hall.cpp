#include "scenes/common/solids.hpp"
#include "scenes/factory/elements.hpp"

#include <algorithm>
#include <cmath>

namespace alcove::factory {
namespace {

constexpr glm::vec3 kConcrete(0.56f, 0.55f, 0.53f);
constexpr glm::vec3 kBrick(0.52f, 0.38f, 0.32f);
constexpr glm::vec3 kSteel(0.4f, 0.46f, 0.48f);

/// A long wall with a window a bay, from z = 0 to z = 0.4.
Mesh make_wall() {
    constexpr double kEnd = kHalfLength + 0.2;
    std::vector<Contour> windows;
    for (int bay = 0; bay < kBays; ++bay) {
        const double x = -kHalfLength + kBay * (bay + 0.5);
        windows.push_back({{x - 1.5, 4.4}, {x + 1.5, 4.4}, {x + 1.5, 7.2}, {x - 1.5, 7.2}});
    }
    MeshBuilder builder;
    add_extrusion(builder, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}},
                  {{-kEnd, -0.2}, {kEnd, -0.2}, {kEnd, kEaves + 0.3}, {-kEnd, kEaves + 0.3}},
                  windows, 0.4);
    return builder.finish("wall", kBrick, 0.0);
}

/// Frame and bars of a window about the middle of its opening.
Mesh make_window(const Fineness& fineness) {
    MeshBuilder builder;
    const int columns = fineness.count(4);
    for (int i = 0; i <= columns; ++i) {
        const double x = -1.5 + 3.0 * i / columns;
        add_box(builder, {x - 0.04, -1.45, -0.05}, {x + 0.04, 1.45, 0.05});
    }
    const int rows = fineness.count(3);
    for (int i = 0; i <= rows; ++i) {
        const double y = -1.4 + 2.8 * i / rows;
        add_box(builder, {-1.55, y - 0.04, -0.04}, {1.55, y + 0.04, 0.04});
    }
    return builder.finish("window", glm::vec3(0.3f), 0.0);
}

/// Section of a rolled beam, about 0.
Contour make_beam_section(double half_width, double half_height) {
    constexpr double kWeb = 0.02;
    constexpr double kFlange = 0.035;
    const double w = half_width;
    const double h = half_height;
    return {{-w, -h},
            {w, -h},
            {w, -h + kFlange},
            {kWeb, -h + kFlange},
            {kWeb, h - kFlange},
            {w, h - kFlange},
            {w, h},
            {-w, h},
            {-w, h - kFlange},
            {-kWeb, h - kFlange},
            {-kWeb, -h + kFlange},
            {-w, -h + kFlange}};
}

Mesh make_column() {
    MeshBuilder builder;
    // Its section lies in the plane of x and z; pushed upwards.
    add_extrusion(builder, {{0.0, -0.1, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}},
                  make_beam_section(0.16, 0.2), {}, kEaves + 0.05);
    add_box(builder, {-0.3, -kSink, -0.27}, {0.3, 0.06, 0.27});
    return builder.finish("column", kSteel, 0.0);
}

/// Across the hall, with chords and diagonals.
Mesh make_truss(const Fineness& fineness) {
    const int around = fineness.segments(6);
    const double end = kHalfWidth - 0.2;
    const auto top = [end](double z) { return kEaves + 1.7 - 1.4 * std::abs(z) / end; };
    MeshBuilder builder;
    add_bar(builder, {0.0, kEaves - 0.1, -end}, {0.0, kEaves - 0.1, end}, 0.09, around);
    for (const double side : {-1.0, 1.0}) {
        add_bar(builder, {0.0, top(0.0), -side * 0.03}, {0.0, top(end), side * end}, 0.08, around);
    }
    constexpr int kFields = 10;
    for (int i = 0; i < kFields; ++i) {
        const double a = -end + 2.0 * end * i / kFields;
        const double b = a + 2.0 * end / kFields;
        const bool rises = i < kFields / 2;
        add_bar(builder, {0.0, rises ? kEaves - 0.1 : top(a), a},
                {0.0, rises ? top(b) : kEaves - 0.1, b}, 0.045, around);
        add_bar(builder, {0.0, kEaves - 0.1, b}, {0.0, top(b), b}, 0.04, around);
    }
    return builder.finish("truss", kSteel, 40.0);
}

} // namespace

void add_hall(SceneKit& kit, const Fineness& fineness) {
    const double end = kHalfLength;
    kit.add(make_box_mesh("floor", kConcrete, {-end - 0.5, -0.3, -kHalfWidth - 0.7},
                          {end + 0.5, 0.0, kHalfWidth + 0.7}));
    const std::size_t wall = kit.add_mesh(make_wall());
    kit.place(wall, make_place({0.0, 0.0, kHalfWidth}));
    kit.place(wall, make_place({0.0, 0.0, -kHalfWidth - 0.4}));
    for (const double side : {-1.0, 1.0}) {
        const double face = side * end;
        kit.add(
            make_box_mesh(side < 0.0 ? "west wall" : "east wall", kBrick,
                          {std::min(face, face + side * 0.35), -0.15, -kHalfWidth - 0.1},
                          {std::max(face, face + side * 0.35), kEaves + 2.4, kHalfWidth + 0.1}));
        // Roof: a sloping slab a side, its ridge in the middle.
        MeshBuilder roof;
        const double reach = kHalfWidth + 0.6;
        const Contour section{{0.0, 9.85}, {reach, 8.35}, {reach, 8.55}, {0.0, 10.05}};
        Contour outline;
        for (const glm::dvec2& point : section) {
            outline.emplace_back(side * (point.x - 0.02), point.y);
        }
        if (side > 0.0) {
            std::reverse(outline.begin(), outline.end());
        }
        add_extrusion(
            roof,
            {{-end - 0.3 + 0.02 * side, side * 0.004, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}},
            outline, {}, 2.0 * end + 0.6);
        kit.add(roof.finish(side < 0.0 ? "south roof" : "north roof", glm::vec3(0.45f), 0.0));
    }
    const std::size_t window = kit.add_mesh(make_window(fineness));
    const std::size_t column = kit.add_mesh(make_column());
    const std::size_t truss = kit.add_mesh(make_truss(fineness));
    for (int line = 0; line <= kBays; ++line) {
        const double x = std::clamp(-end + kBay * line, -end + 0.35, end - 0.35);
        kit.place(truss, make_place({x, 0.0, 0.0}));
        for (const double side : {-1.0, 1.0}) {
            kit.place(column, make_place({x, 0.0, side * (kHalfWidth - 0.25)}));
            if (line < kBays) {
                kit.place(window,
                          make_place({-end + kBay * (line + 0.5), 5.8, side * (kHalfWidth + 0.2)}));
            }
        }
    }
    // Rails of the crane on brackets.
    for (const double side : {-1.0, 1.0}) {
        const double z = side * (kHalfWidth - 0.75);
        MeshBuilder builder;
        add_extrusion(builder, {{-end - 0.05, 6.5, z}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}},
                      make_beam_section(0.15, 0.2), {}, 2.0 * end + 0.1);
        for (int line = 0; line <= kBays; ++line) {
            const double x = std::clamp(-end + kBay * line, -end + 0.35, end - 0.35);
            const double wall_side = side * (kHalfWidth - 0.35);
            add_box(builder, {x - 0.1, 6.05, std::min(wall_side, z - side * 0.1)},
                    {x + 0.1, 6.32, std::max(wall_side, z - side * 0.1)});
        }
        kit.add(builder.finish(side < 0.0 ? "south rail" : "north rail", kSteel, 0.0));
    }
}

} // namespace alcove::factory
