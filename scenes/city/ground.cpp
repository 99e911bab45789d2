#include "scenes/city/elements.hpp"
#include "scenes/common/solids.hpp"

#include <cmath>

namespace alcove::city {
namespace {

constexpr double kHalfCity = 0.5 * kPitch * kBlocks + 60.0; ///< of the ground
constexpr double kRail = 0.025;                             ///< height above the carriageway

/// Of the reach: a kerb is as long as a block.
constexpr double kKerbReach = 3.0;

/// Cells of half a block: no triangle is so long that its attributes lose their bits.
void add_carriageways(Kit& kit) {
    Sheet sheet;
    sheet.columns = 2 * kBlocks + 2;
    sheet.rows = sheet.columns;
    const double step = 2.0 * kHalfCity / sheet.columns;
    sheet.place = [step](int column, int row) {
        return glm::dvec2(-kHalfCity + step * column, -kHalfCity + step * row);
    };
    sheet.lower = [](int, int) { return -1.0; };
    sheet.upper = [](int, int) { return 0.0; };
    sheet.falls = [](int, int) { return false; };
    MeshBuilder builder;
    add_sheet(builder, sheet);
    kit.place(kit.add_mesh(builder.finish("carriageways", kAsphalt, 30.0)), glm::dmat4(1.0));
}

/// Two tracks in the street z = 0, in pieces of a block's length.
void add_rails(Kit& kit) {
    MeshBuilder builder;
    for (const double track : {-kTrackZ, kTrackZ}) {
        for (const double side : {-0.5, 0.5}) {
            const double z = track + side * kGauge;
            add_bar(
                builder,
                {{z - 0.035, -kSink}, {z + 0.035, -kSink}, {z + 0.035, kRail}, {z - 0.035, kRail}},
                -0.5 * kPitch - 0.01, 0.5 * kPitch - 0.02);
        }
    }
    const std::size_t rails = kit.add_mesh(builder.finish("rails", kIron, 30.0));
    for (int i = 0; i < kBlocks; ++i) {
        kit.place(rails, make_frame({kPitch * (i - 0.5 * (kBlocks - 1)), 0.0, 0.0}));
    }
}

/// Pavement with rounded corners; the kerb's stones stand up to a finger higher.
std::size_t make_pavement(Kit& kit) {
    constexpr double kRadius = 2.0;
    Contour outline; // in (z, x): z cross x points up
    for (int corner = 0; corner < 4; ++corner) {
        const double middle = kKerb - kRadius;
        const double from = 0.5 * std::acos(-1.0) * corner;
        const double to = from + 0.5 * std::acos(-1.0);
        const Contour arc =
            make_arc({corner == 0 || corner == 3 ? middle : -middle, corner < 2 ? middle : -middle},
                     {kRadius, kRadius}, from, to, kit.segments(3, 2));
        outline.insert(outline.end(), arc.begin(), arc.end());
    }
    MeshBuilder builder;
    add_extrusion(builder, {{0.0, -0.4, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}, outline, {},
                  0.4 + kPavement);
    return kit.add_mesh(builder.finish("pavement", kPaving, 30.0));
}

/// One side of a block, south; from two steps on in single stones.
std::size_t make_kerb(Kit& kit) {
    constexpr double kHalf = kKerb - 2.0;
    const int stones = kit.steps() == 1 ? 1 : 4 * kit.count(4.0, 1);
    const double length = 2.0 * kHalf / stones;
    const double joint = kit.steps() == 1 ? 0.0 : 0.006;
    MeshBuilder builder;
    for (int i = 0; i < stones; ++i) {
        const double from = -kHalf + length * i;
        const double top = kPavement + 0.012 + (i % 2 == 0 ? 0.0 : 0.003);
        add_bar(builder,
                {{kKerb - 0.28, -0.3},
                 {kKerb + 0.03, -0.3},
                 {kKerb + 0.03, top - 0.04},
                 {kKerb - 0.01, top},
                 {kKerb - 0.28, top}},
                from + joint, from + length - joint);
    }
    return kit.add_mesh(builder.finish("kerb", kStone, 30.0));
}

} // namespace

void add_ground(Kit& kit, const Plan& plan) {
    add_carriageways(kit);
    add_rails(kit);
    const std::size_t pavement = make_pavement(kit);
    const std::size_t kerb = make_kerb(kit);
    const auto make_lawn = [&kit](const char* name, double half) {
        return kit.add_mesh(
            make_box_mesh(name, kGrass, {-half, -0.2, -half}, {half, kPavement + 0.07, half}));
    };
    const std::size_t court = make_lawn("court_lawn", kHalfBlock - kLotDepth - 5.0);
    const std::size_t park = make_lawn("park_lawn", kHalfBlock - 1.0);
    for (const Block& block : plan.blocks) {
        kit.place(pavement, make_frame(block.middle));
        for (int turns = 0; turns < 4; ++turns) {
            const glm::dmat4 side = make_frame(block.middle, turns);
            const glm::dvec3 middle(side * glm::dvec4(0.0, 0.0, kKerb, 1.0));
            if (measure_distance_to_route(middle) < kKerbReach * kit.reach_m()) {
                kit.place(kerb, side);
            }
        }
        if (block.use != BlockUse::square) {
            kit.place(block.use == BlockUse::park ? park : court, make_frame(block.middle));
        }
    }
}

} // namespace alcove::city
