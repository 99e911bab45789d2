#include "scenes/cathedral/kit.hpp"

#include "scenes/common/solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>

namespace alcove::cathedral {
namespace {

/// Sharper edges than this stay edges.
constexpr double kCreaseDegrees = 70.0; // a hexagon still is round

} // namespace

double get_bay_x(int bay) {
    return -kHalfLength + kBayLength * (bay + 0.5);
}

double get_column_x(int line) {
    return -kHalfLength + kBayLength * line;
}

Kit::Kit(double detail, int seed)
    : m_scale(std::sqrt(0.25 * detail)), m_has_ornament(detail >= 0.2), m_is_crowded(detail > 8.0),
      m_random(static_cast<std::uint64_t>(seed) * 2 + 1) {}

int Kit::segments(int at_four, int minimum) const {
    return std::max(minimum, static_cast<int>(std::lround(at_four * m_scale)));
}

double Kit::spacing(double at_default) const {
    return at_default * std::clamp(std::sqrt(0.5 / m_scale), 0.8, 2.0);
}

double Kit::vary(double value, double fraction) {
    const double unit = m_random.draw_unit();
    return value * (1.0 + fraction * (2.0 * unit - 1.0));
}

std::size_t Kit::add_mesh(Mesh mesh) {
    m_content.meshes.push_back(std::move(mesh));
    return m_content.meshes.size() - 1;
}

void Kit::place(std::size_t mesh, const glm::dvec3& position, int quarter_turns) {
    constexpr std::array<double, 4> kCosines{1.0, 0.0, -1.0, 0.0};
    constexpr std::array<double, 4> kSines{0.0, 1.0, 0.0, -1.0};
    const auto turn = static_cast<std::size_t>(quarter_turns & 3);
    glm::dmat4 transform(1.0);
    transform[0] = {kCosines[turn], 0.0, -kSines[turn], 0.0};
    transform[2] = {kSines[turn], 0.0, kCosines[turn], 0.0};
    constexpr double kGrid = 1048576.0;
    transform[3] = glm::dvec4(glm::round(position * kGrid) / kGrid, 1.0);
    const std::string name = m_content.meshes[mesh].name;
    m_content.objects.push_back({name + "#" + std::to_string(m_content.objects.size()), mesh});
    m_content.transforms.push_back(transform);
}

RigidSceneContent Kit::take() {
    return std::move(m_content);
}

Mesh make_box(std::string name, const glm::vec3& albedo, const glm::dvec3& low,
              const glm::dvec3& high) {
    MeshBuilder builder;
    add_box(builder, low, high);
    return builder.finish(std::move(name), albedo, kCreaseDegrees);
}

Mesh make_lathe(std::string name, const glm::vec3& albedo, const Contour& profile, int segments) {
    MeshBuilder builder;
    add_lathe(builder, profile, segments);
    return builder.finish(std::move(name), albedo, kCreaseDegrees);
}

Contour smooth_profile(const Contour& points, int steps) {
    Contour curve;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const glm::dvec2& before = points[i == 0 ? 0 : i - 1];
        const glm::dvec2& a = points[i];
        const glm::dvec2& b = points[i + 1];
        const glm::dvec2& after = points[std::min(i + 2, points.size() - 1)];
        for (int step = 0; step < steps; ++step) {
            // Catmull-Rom, uniform knots
            const double s = static_cast<double>(step) / steps;
            curve.push_back(0.5 * (2.0 * a + (b - before) * s +
                                   (2.0 * before - 5.0 * a + 4.0 * b - after) * (s * s) +
                                   (3.0 * a - before - 3.0 * b + after) * (s * s * s)));
        }
    }
    curve.push_back(points.back());
    return curve;
}

Contour make_arched_opening(double centre_x, double half_width, double bottom, double spring,
                            int segments) {
    Contour contour{{centre_x - half_width, bottom}, {centre_x + half_width, bottom}};
    const Contour arch =
        make_arc({centre_x, spring}, {half_width, half_width}, 0.0, std::numbers::pi, segments);
    contour.insert(contour.end(), arch.begin(), arch.end());
    return contour;
}

} // namespace alcove::cathedral
