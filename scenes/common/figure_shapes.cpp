#include "scenes/common/figure_shapes.hpp"

#include "core/base/assert.hpp"
#include "scenes/common/solids.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

double blend(double before, double a, double b, double after, double s) {
    // Catmull-Rom, uniform knots
    return 0.5 * (2.0 * a + (b - before) * s + (2.0 * before - 5.0 * a + 4.0 * b - after) * s * s +
                  (3.0 * a - before - 3.0 * b + after) * s * s * s);
}

} // namespace

void add_limb(MeshBuilder& builder, const std::vector<Slice>& slices, int around) {
    std::vector<Ring> rings;
    for (const Slice& slice : slices) {
        Ring ring;
        for (int i = 0; i < around; ++i) {
            const double angle = -kTurn * i / around;
            ring.emplace_back(slice.shift + slice.along * std::cos(angle), slice.y,
                              slice.across * std::sin(angle));
            if (slice.aside != 0.0) { // else -0 stays -0, and hashes of scenes what they are
                ring.back().z += slice.aside;
            }
        }
        rings.push_back(std::move(ring));
    }
    add_loft(builder, rings, LoftEnds::capped);
}

std::vector<Slice> smooth_slices(const std::vector<Slice>& slices, int steps) {
    std::vector<Slice> curve;
    for (std::size_t i = 0; i + 1 < slices.size(); ++i) {
        const Slice& before = slices[i == 0 ? 0 : i - 1];
        const Slice& a = slices[i];
        const Slice& b = slices[i + 1];
        const Slice& after = slices[std::min(i + 2, slices.size() - 1)];
        for (int step = 0; step < steps; ++step) {
            const double s = static_cast<double>(step) / steps;
            const auto mix = [&](double Slice::*field) {
                return blend(before.*field, a.*field, b.*field, after.*field, s);
            };
            // Heights on a line: a curve through uneven ones could turn back.
            curve.push_back({a.y + s * (b.y - a.y), mix(&Slice::along), mix(&Slice::across),
                             mix(&Slice::shift), mix(&Slice::aside)});
        }
    }
    curve.push_back(slices.back());
    return curve;
}

void add_ellipsoid(MeshBuilder& builder, const glm::dvec3& centre, const glm::dvec3& size,
                   int around) {
    const int rows = std::max(4, around / 2);
    std::vector<Slice> slices;
    for (int i = 0; i <= rows; ++i) {
        const double angle = std::numbers::pi * i / rows;
        const double wide = i == 0 || i == rows ? 0.0 : std::sin(angle);
        slices.push_back({centre.y - size.y * std::cos(angle), size.x * wide, size.z * wide,
                          centre.x, centre.z});
    }
    add_limb(builder, slices, around);
}

void add_tube(MeshBuilder& builder, const std::vector<TubePoint>& line, int around) {
    ALCOVE_ASSERT(line.size() >= 2, "a line has two points");
    std::vector<Ring> rings;
    glm::dvec3 side(0.0);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const glm::dvec3 tangent = glm::normalize(line[std::min(i + 1, line.size() - 1)].place -
                                                  line[i == 0 ? 0 : i - 1].place);
        if (i == 0) {
            side =
                std::abs(tangent.y) < 0.8 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
        }
        side = glm::normalize(side - glm::dot(side, tangent) * tangent);
        const glm::dvec3 other = glm::cross(tangent, side);
        Ring ring;
        for (int k = 0; k < around; ++k) {
            const double angle = kTurn * k / around;
            ring.push_back(line[i].place +
                           line[i].radius * (std::cos(angle) * side + std::sin(angle) * other));
        }
        rings.push_back(std::move(ring));
    }
    add_loft(builder, rings, LoftEnds::capped);
}

} // namespace alcove
