#include "scenes/city/kit.hpp"

#include "scenes/common/solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

namespace alcove::city {
namespace {

/// Chosen so that detail 64 has at least the 21,934,980 vertices of the Vienna walkthrough, and at
/// most 3 % more, in: O. Mattausch, D. Scherzer, M. Wimmer. High-Quality Screen-Space Ambient
/// Occlusion using Temporal Coherence. 2010, table 2.
constexpr double kReachGrowth = 0.7362;

} // namespace

Kit::Kit(double detail, int seed)
    : m_detail(detail), m_steps(detail < 4.0 ? 1 : 2),
      m_reach_m(24.0 * std::pow(detail, kReachGrowth)), m_seed(static_cast<std::uint64_t>(seed)) {}

int Kit::segments(int at_default, int minimum) const {
    return std::max(minimum, static_cast<int>(std::lround(at_default * std::pow(m_detail, 0.125))));
}

int Kit::count(double at_default, int minimum) const {
    return std::max(minimum, static_cast<int>(std::lround(at_default * std::pow(m_detail, 0.25))));
}

SplitMix Kit::make_random(std::uint64_t salt) const {
    SplitMix mixed(m_seed * 0x100000001b3ull + salt * 0x9e3779b97f4a7c15ull + 1);
    static_cast<void>(mixed.draw_unit());
    return mixed;
}

std::size_t Kit::add_mesh(Mesh mesh) {
    m_content.meshes.push_back(std::move(mesh));
    return m_content.meshes.size() - 1;
}

std::size_t Kit::place(std::size_t mesh, const glm::dmat4& transform) {
    constexpr double kGrid = 1048576.0;
    glm::dmat4 rounded = transform;
    rounded[3] = glm::round(transform[3] * kGrid) / kGrid;
    const std::size_t index = m_content.objects.size();
    m_content.objects.push_back({m_content.meshes[mesh].name + "#" + std::to_string(index), mesh});
    m_content.transforms.push_back(rounded);
    return index;
}

RigidSceneContent Kit::take() {
    return std::move(m_content);
}

glm::dmat4 make_frame(const glm::dvec3& position, int quarter_turns) {
    constexpr std::array<double, 4> kCosines{1.0, 0.0, -1.0, 0.0};
    constexpr std::array<double, 4> kSines{0.0, 1.0, 0.0, -1.0};
    const auto turn = static_cast<std::size_t>(quarter_turns & 3);
    glm::dmat4 frame(1.0);
    frame[0] = {kCosines[turn], 0.0, -kSines[turn], 0.0};
    frame[2] = {kSines[turn], 0.0, kCosines[turn], 0.0};
    frame[3] = glm::dvec4(position, 1.0);
    return frame;
}

glm::dmat4 make_frame(const glm::dvec3& position, double radians, double scale) {
    glm::dmat4 frame(scale);
    frame[0] = scale * glm::dvec4(std::cos(radians), 0.0, -std::sin(radians), 0.0);
    frame[2] = scale * glm::dvec4(std::sin(radians), 0.0, std::cos(radians), 0.0);
    frame[3] = glm::dvec4(position, 1.0);
    return frame;
}

glm::dmat4 shift(const glm::dmat4& frame, const glm::dvec3& offset) {
    glm::dmat4 moved = frame;
    moved[3] = frame * glm::dvec4(offset, 1.0);
    return moved;
}

double measure_distance_to_route(const glm::dvec3& point) {
    // Along the tram's street, two blocks before the church square.
    const double x = std::clamp(point.x, -232.0, -60.0);
    return std::hypot(point.x - x, point.z);
}

Contour make_rectangle(double left, double bottom, double right, double top) {
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

void add_bar(MeshBuilder& builder, const Contour& section_zy, double from, double to) {
    Contour turned; // to (-z, y): -z cross y is x, the way of the push
    for (const glm::dvec2& point : section_zy) {
        turned.emplace_back(-point.x, point.y);
    }
    add_extrusion(builder, {{from, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}}, turned, {},
                  to - from);
}

} // namespace alcove::city
