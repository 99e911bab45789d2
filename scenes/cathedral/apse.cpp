#include "scenes/cathedral/elements.hpp"
#include "scenes/common/solids.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace alcove::cathedral {
namespace {

constexpr double kPi = std::numbers::pi;

/// A section of (radius, height), counter-clockwise, turned through the half circle that opens to
/// the nave.
Mesh make_half_turn(const char* name, const glm::vec3& albedo, const Contour& section,
                    int segments) {
    std::vector<Ring> rings;
    for (int i = 0; i <= segments; ++i) {
        const double angle = kPi * i / segments - 0.5 * kPi;
        Ring ring;
        for (const glm::dvec2& point : section) {
            ring.emplace_back(point.x * std::cos(angle), point.y, point.x * std::sin(angle));
        }
        rings.push_back(std::move(ring));
    }
    MeshBuilder builder;
    add_loft(builder, rings, LoftEnds::capped);
    return builder.finish(name, albedo, 35.0);
}

/// Wall and half dome in one: 0.8 m thick.
Mesh make_shell(Kit& kit) {
    const int arc = kit.segments(12, 5);
    constexpr double kOuter = kApseRadius + 0.8;
    Contour section{{kApseRadius, -0.22}, {kOuter, -0.22}};
    Contour outer = make_arc({0.0, kApseSpring}, {kOuter, kOuter}, 0.0, 0.5 * kPi, arc);
    Contour inner = make_arc({0.0, kApseSpring}, {kApseRadius, kApseRadius}, 0.5 * kPi, 0.0, arc);
    outer.back().x = 0.0; // cos(pi/2) is not quite zero, and the pole must be one point
    inner.front().x = 0.0;
    section.insert(section.end(), outer.begin(), outer.end());
    section.insert(section.end(), inner.begin(), inner.end());
    return make_half_turn("apse", kPlaster, section, kit.segments(28, 12));
}

void add_apse_ribs(Kit& kit) {
    const int around = kit.segments(10, 6);
    const double girth = kit.vary(0.13, 0.1);
    const std::size_t shaft = kit.add_mesh(make_lathe(
        "apse_shaft", kLightStone,
        {{1.5 * girth, 0.85}, {1.5 * girth, 1.05}, {girth, 1.15}, {girth, 8.05}}, around));
    Contour section = make_arc({0.0, 0.0}, {girth, girth}, 0.0, 2.0 * kPi, around);
    section.pop_back();
    const int segments = kit.segments(14, 4);
    for (const double degrees : {-67.5, -40.0, -13.5, 13.5, 40.0, 67.5}) {
        const double angle = degrees * kPi / 180.0;
        const glm::dvec3 outward(std::cos(angle), 0.0, std::sin(angle));
        std::vector<glm::dvec3> path;
        for (int i = 0; i <= segments; ++i) {
            const double height = 0.47 * kPi * i / segments;
            path.push_back(kApseRadius * std::cos(height) * outward +
                           glm::dvec3(0.0, kApseSpring + kApseRadius * std::sin(height), 0.0));
        }
        MeshBuilder builder;
        add_sweep(builder, section, path, {outward.z, 0.0, -outward.x});
        kit.place(kit.add_mesh(builder.finish("apse_rib", kLightStone, 60.0)), {kApseX, 0.0, 0.0});
        kit.place(shaft, glm::dvec3(kApseX, 0.0, 0.0) + kApseRadius * outward);
    }
    const std::size_t boss = kit.add_mesh(make_lathe(
        "apse_boss", kLightStone,
        smooth_profile({{0.0, 11.35}, {0.4, 11.42}, {0.6, 11.6}, {0.5, 11.85}}, kit.segments(2, 1)),
        kit.segments(16, 8)));
    kit.place(boss, {kApseX, 0.0, 0.0});
}

void add_altar(Kit& kit) {
    const glm::dvec3 place(17.0, kChoirFloor, 0.0);
    kit.place(kit.add_mesh(make_box("altar_step", kStone, {-0.9, -kSink, -1.6}, {0.9, 0.15, 1.6})),
              place);
    kit.place(kit.add_mesh(make_box("altar", kLightStone, {-0.35, 0.1, -0.9}, {0.4, 1.05, 0.9})),
              place);
    kit.place(
        kit.add_mesh(make_box("altar_table", kStone, {-0.45, 1.02, -1.05}, {0.5, 1.14, 1.05})),
        place);
    const std::size_t candlestick = kit.add_mesh(make_lathe("candlestick", kDarkStone,
                                                            smooth_profile({{0.09, 1.11},
                                                                            {0.08, 1.16},
                                                                            {0.02, 1.22},
                                                                            {0.03, 1.4},
                                                                            {0.015, 1.5},
                                                                            {0.05, 1.62},
                                                                            {0.012, 1.66},
                                                                            {0.012, 1.95}},
                                                                           kit.segments(2, 1)),
                                                            kit.segments(10, 6)));
    for (const double z : {-0.8, -0.5, 0.5, 0.8}) {
        kit.place(candlestick, place + glm::dvec3(0.1, 0.0, z));
    }
}

} // namespace

void add_apse(Kit& kit) {
    kit.place(kit.add_mesh(make_shell(kit)), {kApseX, 0.0, 0.0});
    const Contour cornice{{kApseRadius - 0.2, 7.98},
                          {kApseRadius - 0.08, 7.82},
                          {kApseRadius + 0.1, 7.82},
                          {kApseRadius + 0.1, 8.1},
                          {kApseRadius - 0.2, 8.1}};
    kit.place(kit.add_mesh(make_half_turn("apse_cornice", kStone, cornice, kit.segments(28, 12))),
              {kApseX + kSink, 0.0, 0.0});
    add_apse_ribs(kit);
    add_altar(kit);
}

} // namespace alcove::cathedral
