#include "scenes/cathedral/elements.hpp"
#include "scenes/common/solids.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove::cathedral {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kChoirX = 10.2;     ///< front edge of the raised floor
constexpr double kBalusterGap = 0.2; ///< from axis to axis

/// Balusters, posts and the ball on a post, shared by all runs.
struct BalustradeParts {
    std::array<std::size_t, 2> balusters{};
    std::size_t post = 0;
    std::size_t ball = 0;
};

Mesh make_baluster(Kit& kit) {
    const double belly = kit.vary(0.07, 0.12);
    const double neck = kit.vary(0.028, 0.15);
    if (kit.segments(12, 1) < 4) { // too few segments for beads
        return make_lathe("baluster", kLightStone,
                          {{0.05, 0.08}, {belly, 0.28}, {neck, 0.58}, {0.055, 0.8}}, 6);
    }
    const Contour points{{0.05, 0.08},  {0.05, 0.13},  {0.032, 0.17}, {belly, 0.28},
                         {0.06, 0.36},  {neck, 0.54},  {neck, 0.62},  {0.05, 0.68},
                         {0.035, 0.72}, {0.055, 0.76}, {0.055, 0.8}};
    return make_lathe("baluster", kLightStone, smooth_profile(points, kit.segments(2, 1)),
                      kit.segments(12, 6));
}

BalustradeParts make_parts(Kit& kit) {
    BalustradeParts parts;
    for (std::size_t& baluster : parts.balusters) {
        baluster = kit.add_mesh(make_baluster(kit));
    }
    parts.post = kit.add_mesh(make_box("post", kStone, {-0.13, -kSink, -0.13}, {0.13, 1.02, 0.13}));
    parts.ball = kit.add_mesh(make_lathe(
        "post_ball", kLightStone,
        smooth_profile({{0.05, 1.0}, {0.06, 1.04}, {0.11, 1.13}, {0.07, 1.22}, {0.0, 1.25}},
                       kit.segments(2, 1)),
        kit.segments(14, 6)));
    return parts;
}

/// Rails and balusters between two points at floor height, along x or along z, with a post at each
/// end.
void add_run(Kit& kit, const BalustradeParts& parts, const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 way = to - from;
    const double length = glm::length(way);
    const bool along_x = std::abs(way.x) > std::abs(way.z);
    const auto make_rail = [&](const char* name, double low, double high, double half) {
        const glm::dvec3 reach =
            along_x ? glm::dvec3(0.5 * length, 0.0, half) : glm::dvec3(half, 0.0, 0.5 * length);
        return make_box(name, kStone, {-reach.x, low, -reach.z}, {reach.x, high, reach.z});
    };
    const glm::dvec3 middle = 0.5 * (from + to);
    kit.place(kit.add_mesh(make_rail("bottom_rail", -0.03, 0.11, 0.09)), middle);
    kit.place(kit.add_mesh(make_rail("hand_rail", 0.77, 0.9, 0.1)), middle);
    const int count =
        std::max(1, static_cast<int>(std::lround(length / kit.spacing(kBalusterGap))) - 1);
    for (int i = 1; i <= count; ++i) {
        const double t = static_cast<double>(i) / (count + 1);
        kit.place(parts.balusters[static_cast<std::size_t>(i) % parts.balusters.size()],
                  from + t * way);
    }
    for (const glm::dvec3& end : {from, to}) {
        kit.place(parts.post, end);
        kit.place(parts.ball, end);
    }
}

void add_raised_floor(Kit& kit) {
    constexpr double kDeep = 0.08; // below the plinths and the stairs
    // Drawn in (z, x): z cross x points up. Reaches into the walls of the apse.
    Contour outline{{-3.9, kChoirX}, {3.9, kChoirX}};
    const Contour round = make_arc({0.0, kApseX}, {3.9, 3.9}, 0.0, kPi, kit.segments(24, 10));
    outline.insert(outline.end(), round.begin(), round.end());
    MeshBuilder builder;
    add_extrusion(builder, {{0.0, -kDeep, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}, outline, {},
                  kChoirFloor + kDeep);
    kit.place(kit.add_mesh(builder.finish("choir_floor", kStone, 30.0)));
}

void add_stairs(Kit& kit) {
    constexpr int kSteps = 5; // and the choir's edge is the sixth
    constexpr double kTread = 0.3;
    constexpr double kRise = kChoirFloor / (kSteps + 1);
    Contour profile{{kChoirX - kSteps * kTread, -kSink}, {kChoirX + 0.1, -kSink}};
    profile.emplace_back(kChoirX + 0.1, kSteps * kRise);
    for (int step = kSteps; step >= 1; --step) {
        const double nosing = kChoirX - (kSteps - step + 1) * kTread;
        profile.emplace_back(nosing, step * kRise);
        if (step > 1) {
            profile.emplace_back(nosing, (step - 1) * kRise);
        }
    }
    MeshBuilder steps;
    add_extrusion(steps, {{0.0, 0.0, -1.9}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, profile, {}, 3.8);
    kit.place(kit.add_mesh(steps.finish("stairs", kStone, 30.0)));

    const Contour cheek{{8.45, -0.06}, {10.4, -0.06}, {10.4, 1.2},
                        {10.1, 1.2},   {8.7, 0.5},    {8.45, 0.5}};
    MeshBuilder side;
    add_extrusion(side, {{0.0, 0.0, -0.15}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, cheek, {}, 0.3);
    const std::size_t mesh = kit.add_mesh(side.finish("stair_cheek", kLightStone, 30.0));
    kit.place(mesh, {0.0, 0.0, 1.98});
    kit.place(mesh, {0.0, 0.0, -1.98});
}

/// A loft over the west door on four slender columns.
void add_gallery(Kit& kit, const BalustradeParts& parts) {
    kit.place(kit.add_mesh(
        make_box("gallery_floor", kWood, {-kHalfLength - 0.2, 4.55, -3.8}, {-11.5, 4.9, 3.8})));
    kit.place(kit.add_mesh(make_box("gallery_beam", kWood, {-12.0, 4.3, -3.7}, {-11.6, 4.6, 3.7})));
    const int around = kit.segments(16, 8);
    const std::size_t column = kit.add_mesh(make_lathe("gallery_column", kStone,
                                                       smooth_profile({{0.24, -0.03},
                                                                       {0.23, 0.12},
                                                                       {0.15, 0.22},
                                                                       {0.145, 1.0},
                                                                       {0.13, 3.9},
                                                                       {0.16, 4.1},
                                                                       {0.24, 4.34}},
                                                                      kit.segments(2, 1)),
                                                       around));
    for (const double z : {-3.4, -1.7, 1.7, 3.4}) {
        kit.place(column, {-11.8, 0.0, z});
    }
    add_run(kit, parts, {-11.68, 4.9, -3.62}, {-11.68, 4.9, 3.62});
    for (const double side : {-1.0, 1.0}) {
        add_run(kit, parts, {-14.8, 4.9, side * 3.65}, {-11.95, 4.9, side * 3.65});
    }
}

} // namespace

void add_choir(Kit& kit) {
    add_raised_floor(kit);
    add_stairs(kit);
    const BalustradeParts parts = make_parts(kit);
    for (const double side : {-1.0, 1.0}) {
        add_run(kit, parts, {10.45, kChoirFloor, side * 2.3}, {10.45, kChoirFloor, side * 3.45});
        add_run(kit, parts, {10.75, kChoirFloor, side * 3.7}, {14.35, kChoirFloor, side * 3.7});
    }
    add_gallery(kit, parts);
}

} // namespace alcove::cathedral
