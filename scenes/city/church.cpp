#include "scenes/city/elements.hpp"
#include "scenes/common/solids.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace alcove::city {
namespace {

constexpr glm::vec3 kCopper{0.28f, 0.46f, 0.4f};
constexpr double kPi = std::numbers::pi;

/// Towards +x; the tower stands at its west end, x = -22.
void add_nave(Kit& kit, const glm::dmat4& frame) {
    const int arc = kit.segments(8, 5);
    MeshBuilder walls;
    add_bar(walls, {{-9.0, -0.3}, {9.0, -0.3}, {9.0, 15.0}, {0.0, 24.0}, {-9.0, 15.0}}, -20.0,
            20.0);
    for (int bay = 0; bay < 6; ++bay) {
        for (const double side : {-1.0, 1.0}) {
            const double x = -16.5 + 6.6 * bay;
            // Buttress with an offset halfway up.
            add_box(walls, {x - 0.55, -0.2, side * 9.9 - 1.1}, {x + 0.55, 6.0, side * 9.9 + 1.1});
            add_box(walls, {x - 0.5, 5.9, side * 9.6 - 0.9}, {x + 0.5, 12.5, side * 9.6 + 0.9});
        }
    }
    add_lathe_at(walls, {20.0, 0.0, 0.0}, {{7.5, -0.25}, {7.5, 12.0}, {7.9, 12.3}, {7.9, 12.9}},
                 2 * arc);
    kit.place(kit.add_mesh(walls.finish("church_walls", kStone, 30.0)), frame);
    MeshBuilder roof;
    add_bar(roof,
            {{10.0, 14.1}, {10.0, 14.5}, {0.0, 24.5}, {-10.0, 14.5}, {-10.0, 14.1}, {0.0, 23.9}},
            -20.3, 20.6);
    add_lathe_at(roof, {20.0, 0.0, 0.0}, {{8.3, 12.7}, {8.3, 12.95}, {0.0, 19.0}}, 2 * arc);
    kit.place(kit.add_mesh(roof.finish("church_roof", kCopper, 30.0)), frame);
    MeshBuilder windows;
    MeshBuilder tracery;
    for (int bay = 0; bay < 5; ++bay) {
        const double x = -13.2 + 6.6 * bay;
        const auto draw = [&](double by) {
            Contour contour{{x - 1.1 - by, 3.5 - by}, {x + 1.1 + by, 3.5 - by}};
            const Contour arch = make_arc({x, 11.0}, {1.1 + by, 2.0 + by}, 0.0, kPi, arc);
            contour.insert(contour.end(), arch.begin(), arch.end());
            return contour;
        };
        const Plane south{{0.0, 0.0, 8.5}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
        add_extrusion(tracery, south, draw(0.35), {draw(0.0)}, 0.85);
        add_extrusion(windows, south, draw(0.1), {}, 0.54);
        add_box(tracery, {x - 0.08, 3.3, 8.6}, {x + 0.08, 12.2, 9.25});
        const Plane north{{0.0, 0.0, -9.35}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
        add_extrusion(tracery, north, draw(0.35), {draw(0.0)}, 0.85);
        add_extrusion(windows, {{0.0, 0.0, -9.04}, north.x, north.y}, draw(0.1), {}, 0.54);
        add_box(tracery, {x - 0.08, 3.3, -9.25}, {x + 0.08, 12.2, -8.6});
    }
    kit.place(kit.add_mesh(windows.finish("church_windows", kGlass, 30.0)), frame);
    kit.place(kit.add_mesh(tracery.finish("church_tracery", kStone, 30.0)), frame);
}

void add_tower(Kit& kit, const glm::dmat4& frame) {
    MeshBuilder shaft;
    const auto square = [](double half, double y) {
        return Ring{{-half, y, -half}, {-half, y, half}, {half, y, half}, {half, y, -half}};
    };
    add_loft(shaft, {square(4.6, -0.35), square(4.4, 46.0)}, LoftEnds::capped);
    for (const double y : {12.0, 24.0, 36.0, 45.6}) {
        add_box(shaft, {-4.85, y, -4.85}, {4.85, y + 0.6, 4.85});
    }
    for (const double x : {-4.3, 4.3}) {
        for (const double z : {-4.3, 4.3}) {
            add_box(shaft, {x - 0.75, -0.25, z - 0.75}, {x + 0.75, 44.0, z + 0.75});
            add_loft(shaft,
                     {Ring{{x - 0.6, 45.0, z - 0.6},
                           {x - 0.6, 45.0, z + 0.6},
                           {x + 0.6, 45.0, z + 0.6},
                           {x + 0.6, 45.0, z - 0.6}},
                      Ring{{x - 0.03, 51.0, z - 0.03},
                           {x - 0.03, 51.0, z + 0.03},
                           {x + 0.03, 51.0, z + 0.03},
                           {x + 0.03, 51.0, z - 0.03}}},
                     LoftEnds::capped);
        }
    }
    kit.place(kit.add_mesh(shaft.finish("tower", kStone, 30.0)), frame);
    MeshBuilder openings;
    MeshBuilder frames;
    for (const double y : {28.0, 38.0}) {
        for (const double x : {-1.5, 1.5}) {
            for (const double side : {-1.0, 1.0}) {
                const double face = side * 4.45;
                add_box(openings, {x - 0.6, y, face - 0.35}, {x + 0.6, y + 5.0, face + 0.35});
                add_box(openings, {face - 0.35, y, x - 0.6}, {face + 0.35, y + 5.0, x + 0.6});
                add_box(frames, {x - 0.9, y - 0.4, face - 0.6}, {x + 0.9, y + 0.1, face + 0.6});
                add_box(frames, {face - 0.6, y - 0.4, x - 0.9}, {face + 0.6, y + 0.1, x + 0.9});
            }
        }
    }
    kit.place(kit.add_mesh(openings.finish("tower_openings", kGlass, 30.0)), frame);
    kit.place(kit.add_mesh(frames.finish("tower_sills", kStone, 30.0)), frame);
    MeshBuilder spire;
    add_lathe_at(spire, {0.0, 0.0, 0.0}, {{4.2, 46.1}, {3.2, 49.0}, {0.12, 74.0}, {0.12, 75.5}}, 8);
    add_lathe_at(spire, {0.0, 0.0, 0.0}, {{0.0, 75.2}, {0.4, 75.6}, {0.4, 75.9}, {0.0, 76.3}},
                 kit.segments(8, 6));
    kit.place(kit.add_mesh(spire.finish("spire", kCopper, 30.0)), frame);
}

} // namespace

void add_church(Kit& kit, const Plan& plan) {
    const auto square =
        std::find_if(plan.blocks.begin(), plan.blocks.end(),
                     [](const Block& block) { return block.use == BlockUse::square; });
    const glm::dmat4 frame = make_frame(square->middle + glm::dvec3(8.0, kPavement, -10.0));
    add_nave(kit, frame);
    add_tower(kit, shift(frame, {-22.0, 0.0, 0.0}));
}

} // namespace alcove::city
