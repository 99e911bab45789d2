#include "scenes/common/round_solids.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/factory/elements.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove::factory {
namespace {

constexpr double kPi = std::numbers::pi;

int scale(int at_one, double detail, int minimum) {
    return std::max(minimum, static_cast<int>(std::lround(at_one * std::sqrt(detail))));
}

void add_flange(MeshBuilder& builder, const glm::dvec3& at, const glm::dvec3& way, double radius,
                int around) {
    add_bar(builder, at - 0.25 * radius * way, at + 0.25 * radius * way, 1.4 * radius, around);
}

} // namespace

int Fineness::segments(int at_one) const {
    return scale(at_one, m_detail, 4);
}

int Fineness::count(int at_one) const {
    return scale(at_one, m_detail, 1);
}

void add_bar(MeshBuilder& builder, const glm::dvec3& from, const glm::dvec3& to, double radius,
             int around) {
    add_tube(builder, {from, to}, {radius, radius}, around);
}

void add_pipe(MeshBuilder& builder, const std::vector<glm::dvec3>& corners, double radius,
              double bend, const Fineness& fineness) {
    const int around = fineness.segments(10);
    const int steps = fineness.segments(4);
    std::vector<glm::dvec3> path{corners.front()};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::dvec3 in = glm::normalize(corners[i] - corners[i - 1]);
        const glm::dvec3 out = glm::normalize(corners[i + 1] - corners[i]);
        const double half_turn = 0.5 * std::acos(std::clamp(glm::dot(in, out), -1.0, 1.0));
        const double setback = bend * std::tan(half_turn);
        const glm::dvec3 begin = corners[i] - setback * in;
        const glm::dvec3 inward = glm::normalize(out - glm::dot(out, in) * in);
        const glm::dvec3 centre = begin + bend * inward;
        for (int k = 0; k <= steps; ++k) {
            const double angle = 2.0 * half_turn * k / steps;
            path.push_back(centre + bend * (std::sin(angle) * in - std::cos(angle) * inward));
        }
        add_flange(builder, begin - 0.3 * radius * in, in, radius, around);
        add_flange(builder, path.back() + 0.3 * radius * out, out, radius, around);
    }
    path.push_back(corners.back());
    add_tube(builder, path, std::vector<double>(path.size(), radius), around);
    add_flange(builder, path.front(), glm::normalize(path[1] - path[0]), radius, around);
    add_flange(builder, path.back(), glm::normalize(path.back() - path[path.size() - 2]), radius,
               around);
}

void add_ring(MeshBuilder& builder, const glm::dvec3& centre, double radius, double thickness,
              const Fineness& fineness) {
    const int around = fineness.segments(20);
    const int section = fineness.segments(6);
    std::vector<Ring> rings;
    for (int i = 0; i < around; ++i) {
        const double angle = 2.0 * kPi * i / around;
        const glm::dvec3 out(std::cos(angle), std::sin(angle), 0.0);
        Ring ring;
        for (int k = 0; k < section; ++k) {
            // Counter-clockwise seen from the side the rings go to.
            const double turn = -2.0 * kPi * k / section;
            ring.push_back(centre + (radius + thickness * std::cos(turn)) * out +
                           glm::dvec3(0.0, 0.0, thickness * std::sin(turn)));
        }
        rings.push_back(std::move(ring));
    }
    add_loft(builder, rings, LoftEnds::joined);
}

} // namespace alcove::factory
