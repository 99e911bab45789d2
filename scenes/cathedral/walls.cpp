#include "scenes/cathedral/elements.hpp"
#include "scenes/common/solids.hpp"

#include <numbers>
#include <string>
#include <utility>

namespace alcove::cathedral {
namespace {

constexpr double kArcadeRadius = 2.0;

Mesh extrude(std::string name, const glm::vec3& albedo, const Plane& plane, const Contour& outline,
             const std::vector<Contour>& holes, double depth) {
    MeshBuilder builder;
    add_extrusion(builder, plane, outline, holes, depth);
    return builder.finish(std::move(name), albedo, 30.0);
}

Contour make_rectangle(double left, double bottom, double right, double top) {
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

/// Stands on the columns: arches from below, clerestory windows through and through.
Mesh make_nave_wall(Kit& kit) {
    constexpr double kEnd = kHalfLength + 0.3;
    Contour outline{{-kEnd, kArcadeSpring}};
    std::vector<Contour> windows;
    windows.reserve(kBays);
    for (int bay = 0; bay < kBays; ++bay) {
        const Contour arch =
            make_arc({get_bay_x(bay), kArcadeSpring}, {kArcadeRadius, kArcadeRadius},
                     std::numbers::pi, 0.0, kit.segments(24, 6));
        outline.insert(outline.end(), arch.begin(), arch.end());
        windows.push_back(make_arched_opening(get_bay_x(bay), 0.8, 8.7, 11.2, kit.segments(14, 4)));
    }
    outline.insert(outline.end(), {{kEnd, kArcadeSpring}, {kEnd, 14.7}, {-kEnd, 14.7}});
    return extrude("nave_wall", kPlaster, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}},
                   outline, windows, kNaveWall);
}

void add_outer_walls(Kit& kit) {
    std::vector<Contour> niches;
    niches.reserve(kBays);
    for (int bay = 0; bay < kBays; ++bay) {
        niches.push_back(make_arched_opening(get_bay_x(bay), 0.75, 1.3, 4.0, kit.segments(16, 5)));
    }
    constexpr double kEnd = kHalfLength + 0.45;
    const std::size_t inner = kit.add_mesh(
        extrude("outer_wall", kStone, {}, make_rectangle(-kEnd, -0.15, kEnd, 8.6), niches, 0.55));
    const std::size_t outer = kit.add_mesh(
        make_box("outer_wall_back", kDarkStone, {-kEnd - 0.3, -0.3, 0.0}, {kEnd + 0.3, 8.7, 0.5}));
    for (const int turn : {0, 2}) {
        const double side = turn == 0 ? 1.0 : -1.0;
        kit.place(inner, {0.0, 0.0, side * kAisleOuter}, turn);
        kit.place(outer, {0.0, 0.0, side * (kAisleOuter + 0.5)}, turn);
    }
}

/// Inner leaf with portal recess and rose, outer leaf behind it with a smaller rose: a stepped
/// reveal.
void add_west_wall(Kit& kit) {
    const Plane plane{{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}}; // pushes to +x
    const int rose = kit.segments(40, 16);
    const auto circle = [rose](double radius) {
        Contour contour =
            make_arc({0.0, 10.4}, {radius, radius}, 0.0, 2.0 * std::numbers::pi, rose);
        contour.pop_back(); // the same as the first point
        return contour;
    };
    const std::size_t inner = kit.add_mesh(
        extrude("west_wall", kPlaster, plane, make_rectangle(-9.5, -0.2, 9.5, 14.9),
                {make_arched_opening(0.0, 1.4, -0.1, 2.7, kit.segments(20, 6)), circle(1.7)}, 0.5));
    kit.place(inner, {-kHalfLength - 0.5, 0.0, 0.0});
    const std::size_t outer =
        kit.add_mesh(extrude("west_wall_back", kDarkStone, plane,
                             make_rectangle(-9.3, -0.25, 9.3, 14.8), {circle(1.45)}, 0.55));
    kit.place(outer, {-kHalfLength - 1.0, 0.0, 0.0});
    const std::size_t leaf =
        kit.add_mesh(make_box("door_leaf", kWood, {-0.12, -0.03, -0.66}, {0.09, 2.75, 0.66}));
    kit.place(leaf, {-kHalfLength - 0.42, 0.0, 0.69});
    kit.place(leaf, {-kHalfLength - 0.42, 0.0, -0.69});
}

void add_east_wall(Kit& kit) {
    const Plane plane{{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}};
    constexpr double kOpening = kApseRadius - 0.1;
    Contour outline{{-9.5, -0.2}, {-kOpening, -0.2}};
    const Contour arch = make_arc({0.0, kApseSpring}, {kOpening, kOpening}, std::numbers::pi, 0.0,
                                  kit.segments(32, 12));
    outline.insert(outline.end(), arch.begin(), arch.end());
    outline.insert(outline.end(), {{kOpening, -0.2}, {9.5, -0.2}, {9.5, 14.9}, {-9.5, 14.9}});
    const std::size_t wall = kit.add_mesh(extrude("east_wall", kPlaster, plane, outline, {}, 1.0));
    kit.place(wall, {kHalfLength, 0.0, 0.0});
}

} // namespace

void add_walls(Kit& kit) {
    kit.place(kit.add_mesh(make_box("floor", kDarkStone, {-16.4, -0.5, -9.7}, {20.6, 0.0, 9.7})));
    const std::size_t nave_wall = kit.add_mesh(make_nave_wall(kit));
    kit.place(nave_wall, {0.0, 0.0, kNaveHalfWidth});
    kit.place(nave_wall, {0.0, 0.0, -kNaveHalfWidth}, 2);
    add_outer_walls(kit);
    add_west_wall(kit);
    add_east_wall(kit);
}

} // namespace alcove::cathedral
