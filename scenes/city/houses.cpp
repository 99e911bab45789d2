#include "scenes/city/elements.hpp"
#include "scenes/common/solids.hpp"

#include <map>
#include <numbers>
#include <utility>

namespace alcove::city {
namespace {

constexpr double kHalf = 0.5 * kLotWidth + 0.03; ///< of a house: reaches into its neighbours
/// Chimneys make the skyline: they stand farther off than other ornament.
constexpr double kChimneyReach = 8.0;
constexpr double kSlope = kRoofRise / (0.5 * kLotDepth);

/// The plain house: one prism under its gable.
Mesh make_core(const Style& style, int storeys) {
    const double top = get_wall_height(storeys);
    MeshBuilder builder;
    add_bar(builder,
            {{0.0, -0.7},
             {0.0, top},
             {-0.5 * kLotDepth, top + kRoofRise},
             {-kLotDepth, top},
             {-kLotDepth, -0.7}},
            -kHalf, kHalf);
    return builder.finish("house", style.wall, 0.0);
}

/// Two slopes in courses of tiles and, from two steps on, ridge tiles. y from the top of the wall.
Mesh make_roof(const Kit& kit, const Style& style) {
    constexpr double kOverhang = 1.0;
    const int courses = kit.steps() == 1 ? 1 : kit.count(3.0, 1);
    constexpr double kRun = 0.5 * kLotDepth + kOverhang;
    const double pitch = kRun / courses;
    Contour section;
    // Up the street's slope from eaves to ridge; a course is thick at its foot.
    const auto add_course = [&](double outward, double from, double to) {
        section.emplace_back(-0.5 * kLotDepth + outward * from, kSlope * (0.5 * kLotDepth - from));
        section.emplace_back(-0.5 * kLotDepth + outward * to, kSlope * (0.5 * kLotDepth - to));
    };
    for (int i = 0; i < courses; ++i) {
        add_course(1.0, kRun - pitch * i, kRun - pitch * (i + 1));
        section[section.size() - 2].y += courses == 1 ? 0.15 : 0.19;
        section.back().y += courses == 1 ? 0.15 : 0.12;
    }
    for (int i = courses - 1; i >= 0; --i) {
        add_course(-1.0, kRun - pitch * (i + 1), kRun - pitch * i);
        section[section.size() - 2].y += courses == 1 ? 0.15 : 0.12;
        section.back().y += courses == 1 ? 0.15 : 0.19;
        if (i == courses - 1) {
            section.erase(section.end() - 2); // the ridge is one point
        }
    }
    const std::size_t upper = section.size();
    section.push_back(section[upper - 1] - glm::dvec2(0.0, 0.3));
    section.emplace_back(-0.5 * kLotDepth, kRoofRise - 0.13);
    section.push_back(section[0] - glm::dvec2(0.0, 0.3));
    MeshBuilder builder;
    add_bar(builder, section, -kHalf - 0.05, kHalf + 0.05);
    if (kit.steps() > 1) {
        const int tiles = kit.count(7.0, 8);
        const double length = 2.0 * kHalf / tiles;
        for (int i = 0; i < tiles; ++i) {
            const double from = -kHalf + length * i;
            Contour tile = make_arc({-0.5 * kLotDepth, kRoofRise + 0.02},
                                    {0.2 + 0.02 * (i % 2), 0.2 + 0.02 * (i % 2)}, 0.0,
                                    std::numbers::pi, kit.segments(3, 3));
            add_bar(builder, tile, from, from + length + 0.04 + 0.003 * (i % 3));
        }
    }
    return builder.finish("roof", style.roof, 30.0);
}

/// Two of them near the ridge, with pots from two steps on.
Mesh make_chimneys(const Kit& kit, double chimney_x) {
    MeshBuilder builder;
    for (const double side : {-1.0, 1.0}) {
        const double x = side * chimney_x;
        const double z = -0.5 * kLotDepth + 1.2 * side;
        add_box(builder, {x - 0.7, 2.0, z - 0.35}, {x + 0.7, kRoofRise + 1.1, z + 0.35});
        if (kit.steps() > 1) {
            add_box(builder, {x - 0.78, kRoofRise + 0.95, z - 0.43},
                    {x + 0.78, kRoofRise + 1.16, z + 0.43});
            for (const double pot : {-0.4, 0.0, 0.4}) {
                add_lathe_at(builder, {x + pot, kRoofRise + 1.1, z},
                             {{0.13, 0.0}, {0.11, 0.4}, {0.14, 0.48}, {0.14, 0.55}},
                             kit.segments(5, 4));
            }
        }
    }
    return builder.finish("chimneys", {0.5f, 0.36f, 0.3f}, 50.0);
}

/// Three dormers on the street's slope: walls, lids and panes.
std::vector<std::size_t> add_dormers(Kit& kit, const Style& style) {
    MeshBuilder walls;
    MeshBuilder lids;
    MeshBuilder panes;
    for (const double x : {-1.75 * kBay, 0.25 * kBay, 2.2 * kBay}) {
        const Plane front{{x, 0.0, -6.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
        add_extrusion(walls, front,
                      {{-0.75, 0.7}, {0.75, 0.7}, {0.75, 2.42}, {0.0, 3.05}, {-0.75, 2.42}},
                      {make_rectangle(-0.5, 1.45, 0.5, 2.4)}, 4.6);
        add_extrusion(
            lids, {{x, 0.0, -6.2}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}},
            {{-0.95, 2.3}, {-0.9, 2.22}, {0.0, 2.94}, {0.9, 2.22}, {0.95, 2.3}, {0.0, 3.2}}, {},
            5.0);
        add_box(panes, {x - 0.56, 1.4, -6.1}, {x + 0.56, 2.46, -1.55});
        if (kit.steps() > 1) {
            add_box(walls, {x - 0.03, 1.38, -1.6}, {x + 0.03, 2.48, -1.47});
            add_box(walls, {x - 0.54, 1.9, -1.61}, {x + 0.54, 1.96, -1.48});
            add_box(walls, {x - 0.62, 1.3, -1.7}, {x + 0.62, 1.42, -1.27});
        }
    }
    return {kit.add_mesh(walls.finish("dormer_walls", style.trim, 30.0)),
            kit.add_mesh(lids.finish("dormer_roofs", style.roof, 30.0)),
            kit.add_mesh(panes.finish("dormer_panes", kGlass, 30.0))};
}

} // namespace

void add_houses(Kit& kit, const Plan& plan, const std::vector<Style>& styles) {
    std::map<std::pair<int, int>, std::size_t> cores;
    std::vector<std::size_t> roofs;
    std::vector<std::size_t> chimneys;
    std::vector<std::vector<std::size_t>> dormers;
    SplitMix random = kit.make_random(0x40u);
    for (const Style& style : styles) {
        roofs.push_back(kit.add_mesh(make_roof(kit, style)));
        chimneys.push_back(kit.add_mesh(make_chimneys(kit, random.draw(3.0, 8.0))));
        dormers.push_back(add_dormers(kit, style));
        for (int storeys = kLowestHouse; storeys <= kHighestHouse; ++storeys) {
            const int number = static_cast<int>(dormers.size()) - 1;
            cores[{number, storeys}] = kit.add_mesh(make_core(style, storeys));
        }
    }
    for (const Lot& lot : plan.lots) {
        const auto style = static_cast<std::size_t>(lot.style);
        const glm::dmat4 raised = shift(lot.frame, {0.0, lot.lift, 0.0});
        kit.place(cores.at({lot.style, lot.storeys}), raised);
        const glm::dmat4 eaves = shift(raised, {0.0, get_wall_height(lot.storeys), 0.0});
        kit.place(roofs[style], eaves);
        if (lot.distance_m < kChimneyReach * kit.reach_m()) {
            kit.place(chimneys[style], eaves);
        }
        if (lot.distance_m < kit.reach_m()) {
            for (const std::size_t part : dormers[style]) {
                kit.place(part, eaves);
            }
        }
    }
}

} // namespace alcove::city
