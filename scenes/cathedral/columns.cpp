#include "scenes/cathedral/elements.hpp"
#include "scenes/common/solids.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace alcove::cathedral {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kVariants = 3;
constexpr int kFlutes = 20;

/// A round ring whose radius depends on the angle.
template <class Radius>
Ring make_ring(double y, int points, const Radius& radius) {
    Ring ring;
    for (int i = 0; i < points; ++i) {
        const double angle = 2.0 * kPi * i / points;
        const double r = radius(angle);
        ring.emplace_back(r * std::cos(angle), y, -r * std::sin(angle));
    }
    return ring;
}

/// Fluted, tapering with entasis; the flutes run out into plain collars above and below.
Mesh make_shaft(Kit& kit) {
    const double depth = kit.vary(0.035, 0.25);
    const double girth = kit.vary(0.42, 0.03);
    const int around = kit.has_ornament() ? kFlutes * kit.segments(4, 1) : 10;
    const int up = kit.segments(6, 1);
    std::vector<double> heights{0.55, 0.72};
    for (int i = 0; i <= up; ++i) {
        heights.push_back(0.84 + (3.92 - 0.84) * i / up);
    }
    heights.insert(heights.end(), {4.04, 4.25});
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const bool plain = i < 2 || i + 2 >= heights.size();
        const double t = (heights[i] - 0.55) / 3.7;
        const double radius = girth * (1.0 - 0.12 * t + 0.06 * t * (1.0 - t));
        rings.push_back(make_ring(heights[i], around, [&](double angle) {
            const double flute = std::abs(std::sin(0.5 * kFlutes * angle));
            return plain ? radius : radius - depth * flute;
        }));
    }
    MeshBuilder builder;
    add_loft(builder, rings, LoftEnds::capped);
    return builder.finish("column_shaft", kLightStone, 40.0);
}

/// From a circle to a square, with two wreaths of leaves.
Mesh make_capital(Kit& kit) {
    const double leaf = kit.vary(0.035, 0.4);
    const int around = 8 * kit.segments(6, 1);
    const int up = kit.segments(10, 3);
    std::vector<Ring> rings;
    for (int i = 0; i <= up; ++i) {
        const double t = static_cast<double>(i) / up;
        const double flare = 0.38 + 0.17 * t * t;
        const double wreath = leaf * std::abs(std::sin(2.0 * kPi * t)) * (0.5 + t);
        const double phase = t < 0.5 ? 0.0 : kPi;
        rings.push_back(make_ring(4.18 + 0.74 * t, around, [&](double angle) {
            const double c = std::abs(std::cos(angle));
            const double s = std::abs(std::sin(angle));
            // Superellipse: exponent 2 is a circle, 6 nearly a square.
            const double exponent = 2.0 + 4.0 * t * t;
            const double round =
                std::pow(std::pow(c, exponent) + std::pow(s, exponent), -1.0 / exponent);
            return flare * round + wreath * (0.5 + 0.5 * std::cos(8.0 * angle + phase));
        }));
    }
    MeshBuilder builder;
    add_loft(builder, rings, LoftEnds::capped);
    return builder.finish("column_capital", kLightStone, 55.0);
}

/// Attic base: torus, scotia, torus.
Mesh make_base(Kit& kit) {
    const double bulge = kit.vary(0.06, 0.2);
    const int arc = kit.segments(4, 1);
    Contour profile{{0.5, 0.2}};
    const auto append = [&profile](const Contour& part) {
        profile.insert(profile.end(), part.begin(), part.end());
    };
    append(make_arc({0.5, 0.30}, {bulge, 0.07}, -0.5 * kPi, 0.5 * kPi, arc));
    append(make_arc({0.5, 0.43}, {0.04, 0.05}, 1.5 * kPi, 0.5 * kPi, arc)); // hollow
    append(make_arc({0.46, 0.53}, {0.7 * bulge, 0.045}, -0.5 * kPi, 0.5 * kPi, arc));
    profile.emplace_back(0.4, 0.62);
    return make_lathe("column_base", kStone, profile, kit.segments(28, 6));
}

void add_arcade_columns(Kit& kit) {
    const std::size_t plinth =
        kit.add_mesh(make_box("column_plinth", kStone, {-0.6, -kSink, -0.6}, {0.6, 0.25, 0.6}));
    const std::size_t abacus =
        kit.add_mesh(make_box("column_abacus", kStone, {-0.62, 4.86, -0.62}, {0.62, 5.04, 0.62}));
    std::array<std::array<std::size_t, 3>, kVariants> variants{};
    for (auto& parts : variants) {
        parts = {kit.add_mesh(make_base(kit)), kit.add_mesh(make_shaft(kit)),
                 kit.add_mesh(make_capital(kit))};
    }
    for (int line = 0; line <= kBays; ++line) {
        for (const int side : {-1, 1}) {
            const glm::dvec3 foot(get_column_x(line), 0.0, side * kColumnZ);
            const auto pick = static_cast<std::size_t>(kit.vary(0.5, 1.0) * kVariants) % kVariants;
            kit.place(plinth, foot);
            for (const std::size_t part : variants[pick]) {
                kit.place(part, foot, line);
            }
            kit.place(abacus, foot);
        }
    }
}

/// From the abacus up to where the vault springs.
void add_wall_shafts(Kit& kit) {
    const int around = kit.segments(12, 6);
    const std::size_t shaft = kit.add_mesh(make_lathe(
        "wall_shaft", kLightStone, {{0.16, 5.0 - 0.03}, {0.14, 5.3}, {0.14, 9.7}}, around));
    const std::size_t corbel = kit.add_mesh(make_lathe(
        "wall_shaft_capital", kLightStone,
        smooth_profile({{0.13, 9.55}, {0.2, 9.6}, {0.17, 9.68}, {0.27, 9.88}, {0.43, 10.0}},
                       kit.segments(2, 1)),
        around));
    const std::size_t abacus = kit.add_mesh(
        make_box("wall_shaft_abacus", kStone, {-0.48, 9.94, -0.5}, {0.48, 10.13, 0.1}));
    for (int line = 0; line <= kBays; ++line) {
        for (const int turn : {0, 2}) {
            const double side = turn == 0 ? 1.0 : -1.0;
            const glm::dvec3 place(get_column_x(line), 0.0, side * kNaveHalfWidth);
            kit.place(shaft, place, turn);
            kit.place(corbel, place, turn);
            kit.place(abacus, place, turn);
        }
    }
}

void add_responds(Kit& kit) {
    const std::size_t pilaster =
        kit.add_mesh(make_box("respond", kStone, {-0.3, -kSink, -0.25}, {0.3, 4.72, 0.1}));
    const std::size_t foot =
        kit.add_mesh(make_box("respond_base", kStone, {-0.37, -0.07, -0.32}, {0.37, 0.3, 0.08}));
    const std::size_t capital = kit.add_mesh(
        make_box("respond_capital", kLightStone, {-0.4, 4.66, -0.42}, {0.4, 5.06, 0.12}));
    for (int line = 0; line <= kBays; ++line) {
        for (const int turn : {0, 2}) {
            const double side = turn == 0 ? 1.0 : -1.0;
            const glm::dvec3 place(get_column_x(line), 0.0, side * kAisleOuter);
            kit.place(pilaster, place, turn);
            kit.place(foot, place, turn);
            kit.place(capital, place, turn);
        }
    }
}

} // namespace

void add_columns(Kit& kit) {
    add_arcade_columns(kit);
    add_wall_shafts(kit);
    add_responds(kit);
}

} // namespace alcove::cathedral
