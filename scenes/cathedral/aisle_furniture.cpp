#include "scenes/cathedral/elements.hpp"
#include "scenes/common/solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace alcove::cathedral {
namespace {

constexpr double kPi = std::numbers::pi;

/// Turned legs and spindles, a seat with rounded corners; looks towards +x.
Mesh make_chair(const Kit& kit) {
    const int around = kit.segments(4, 6);
    const int steps = kit.segments(1, 1);
    MeshBuilder builder;
    const Contour leg = smooth_profile(
        {{0.016, -0.02}, {0.022, 0.1}, {0.016, 0.14}, {0.026, 0.3}, {0.018, 0.44}}, steps);
    const Contour spindle = smooth_profile(
        {{0.011, 0.45}, {0.015, 0.56}, {0.009, 0.62}, {0.015, 0.7}, {0.01, 0.86}}, steps);
    for (const double z : {-0.17, 0.17}) {
        for (const double x : {-0.17, 0.17}) {
            add_lathe_at(builder, {x, 0.0, z}, leg, around);
        }
        add_lathe_at(
            builder, {-0.185, 0.0, 1.05 * z},
            smooth_profile({{0.018, 0.43}, {0.022, 0.6}, {0.016, 0.68}, {0.02, 0.93}}, steps),
            around);
    }
    for (int i = -2; i <= 2; ++i) {
        add_lathe_at(builder, {-0.185, 0.0, 0.06 * i}, spindle, around);
    }
    std::vector<Ring> seat;
    for (const auto& [half, y] : {glm::dvec2(0.2, 0.425), glm::dvec2(0.22, 0.435),
                                  glm::dvec2(0.22, 0.455), glm::dvec2(0.205, 0.468)}) {
        Ring ring;
        const int corners = 8 * kit.segments(2, 1);
        for (int i = 0; i < corners; ++i) {
            const double angle = -2.0 * kPi * i / corners;
            // Superellipse of exponent 6: a square with round corners.
            const double size = half * std::pow(std::pow(std::abs(std::cos(angle)), 6.0) +
                                                    std::pow(std::abs(std::sin(angle)), 6.0),
                                                -1.0 / 6.0);
            ring.emplace_back(size * std::cos(angle), y, size * std::sin(angle));
        }
        seat.push_back(std::move(ring));
    }
    add_loft(builder, seat, LoftEnds::capped);
    add_box(builder, {-0.2, 0.84, -0.23}, {-0.17, 0.91, 0.23});
    return builder.finish("chair", kWood, 70.0);
}

/// Up to ten chairs a bay, in two rows along the outer walls.
void add_chairs(Kit& kit) {
    const std::size_t chair = kit.add_mesh(make_chair(kit));
    constexpr int kSeats = 5; // a row
    const int chairs = std::min(2 * kSeats, kit.segments(2, 2));
    for (int bay = 0; bay < kBays; ++bay) {
        for (const double side : {-1.0, 1.0}) {
            for (int i = 0; i < chairs; ++i) {
                const double x = get_bay_x(bay) - 1.6 + 0.8 * (i % kSeats);
                kit.place(chair, {x, 0.0, side * (i < kSeats ? 7.65 : 7.1)});
            }
        }
    }
}

/// An iron stand with three trays.
struct Tray {
    double radius;
    double height;
};
constexpr std::array<Tray, 3> kTrays{{{0.3, 0.8}, {0.2, 0.98}, {0.1, 1.14}}};

Mesh make_stand(const Kit& kit) {
    const int around = kit.segments(10, 8);
    const int steps = kit.segments(1, 1);
    MeshBuilder builder;
    add_lathe(builder,
              smooth_profile({{0.24, -0.02},
                              {0.22, 0.04},
                              {0.05, 0.1},
                              {0.03, 0.3},
                              {0.05, 0.36},
                              {0.025, 0.42},
                              {0.022, 1.13}},
                             steps),
              around);
    for (const Tray& tray : kTrays) {
        add_lathe(builder,
                  smooth_profile({{0.02, tray.height - 0.05},
                                  {0.7 * tray.radius, tray.height - 0.03},
                                  {tray.radius + 0.02, tray.height},
                                  {tray.radius + 0.02, tray.height + 0.02},
                                  {tray.radius, tray.height + 0.01},
                                  {0.021, tray.height}},
                                 steps),
                  around);
    }
    return builder.finish("candle_stand", kDarkStone, 50.0);
}

void add_candles(Kit& kit) {
    const std::size_t stand = kit.add_mesh(make_stand(kit));
    // Wax, and a flame that is a drop.
    const std::size_t candle = kit.add_mesh(make_lathe("candle", kPlaster,
                                                       smooth_profile({{0.013, -0.02},
                                                                       {0.013, 0.1},
                                                                       {0.011, 0.15},
                                                                       {0.003, 0.152},
                                                                       {0.003, 0.16},
                                                                       {0.007, 0.175},
                                                                       {0.0, 0.2}},
                                                                      kit.segments(1, 1)),
                                                       kit.segments(4, 6)));
    const int burning = std::min(14, kit.segments(3, 3)); // on the lowest tray
    for (int line = 1; line < kBays; ++line) {
        for (const double side : {-1.0, 1.0}) {
            const glm::dvec3 foot(get_column_x(line), 0.0, side * (kColumnZ + 1.0));
            kit.place(stand, foot);
            for (const Tray& tray : kTrays) {
                const int count =
                    std::max(2, static_cast<int>(burning * tray.radius / kTrays[0].radius));
                for (int i = 0; i < count; ++i) {
                    const double angle = 2.0 * kPi * i / count + line;
                    kit.place(candle, foot + glm::dvec3(0.87 * tray.radius * std::cos(angle),
                                                        tray.height + 0.01,
                                                        0.87 * tray.radius * std::sin(angle)));
                }
            }
        }
    }
}

} // namespace

void add_aisle_furniture(Kit& kit) {
    if (kit.is_crowded()) {
        add_chairs(kit);
        add_candles(kit);
    }
}

} // namespace alcove::cathedral
