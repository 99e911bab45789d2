#include "scenes/common/knot.hpp"

#include "scenes/common/mesh_builder.hpp"
#include "scenes/common/solids.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kRing = 0.33;  ///< radius of the torus's core, metres
constexpr double kWind = 0.165; ///< of its tube, on which the rope lies
constexpr double kRope = 0.088;

/// The rope's middle line: twice around, three times through; a lobe on top.
glm::dvec3 place_line(double t) {
    const double around = 2.0 * t + 0.5 * std::numbers::pi;
    const double out = kRing + kWind * std::cos(3.0 * t);
    return {out * std::cos(around), out * std::sin(around), kWind * std::sin(3.0 * t)};
}

/// Away from the torus's core.
glm::dvec3 point_outward(double t) {
    const double around = 2.0 * t + 0.5 * std::numbers::pi;
    return {std::cos(3.0 * t) * std::cos(around), std::cos(3.0 * t) * std::sin(around),
            std::sin(3.0 * t)};
}

/// Strands that wind around the rope, and a fine chisel on them.
double carve(double t, double turn) {
    const double sine = std::sin(0.5 * (4.0 * turn + 18.0 * t));
    const double strand = 1.0 - std::pow(sine * sine, 4.0); // 0 in the groove, 1 on the strand
    const double chisel = std::cos(140.0 * t - 6.0 * turn);
    return kRope * (0.85 + 0.2 * strand + 0.012 * chisel * strand);
}

} // namespace

Mesh make_knot(double detail, const glm::vec3& albedo) {
    const double scale = std::sqrt(detail);
    const int along = std::max(60, static_cast<int>(std::lround(700.0 * scale)));
    const int around = std::max(12, static_cast<int>(std::lround(44.0 * scale)));
    std::vector<Ring> rings;
    double lowest = 0.0;
    for (int i = 0; i < along; ++i) {
        const double t = kTurn * i / along;
        const glm::dvec3 middle = place_line(t);
        const glm::dvec3 tangent = glm::normalize(place_line(t + 1e-4) - place_line(t - 1e-4));
        const glm::dvec3 raw = point_outward(t);
        const glm::dvec3 side = glm::normalize(raw - glm::dot(raw, tangent) * tangent);
        const glm::dvec3 other = glm::cross(tangent, side);
        Ring ring;
        for (int k = 0; k < around; ++k) {
            const double turn = kTurn * k / around;
            ring.push_back(middle +
                           carve(t, turn) * (std::cos(turn) * side + std::sin(turn) * other));
            lowest = std::min(lowest, ring.back().y);
        }
        rings.push_back(std::move(ring));
    }
    for (Ring& ring : rings) {
        for (glm::dvec3& point : ring) {
            point.y -= lowest;
        }
    }
    MeshBuilder builder;
    add_loft(builder, rings, LoftEnds::joined);
    return builder.finish("knot", albedo, 180.0);
}

} // namespace alcove
