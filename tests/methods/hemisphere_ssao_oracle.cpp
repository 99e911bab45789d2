#include "tests/methods/hemisphere_ssao_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

double reverse_digits(int index, int base) {
    double value = 0.0;
    for (double digit = 1.0 / base; index > 0; index /= base, digit /= base) {
        value += digit * (index % base);
    }
    return value;
}

struct Sample {
    glm::dvec3 direction; ///< z along the normal
    double step = 0.0;    ///< in radii
};

Sample make_sample(int index, KernelDirections directions) {
    const double u = reverse_digits(index, 2);
    const double azimuth = 2.0 * std::numbers::pi * reverse_digits(index, 3);
    const double z = directions == KernelDirections::uniform ? u : std::sqrt(u);
    const double horizontal = std::sqrt(1.0 - z * z);
    return {{horizontal * std::cos(azimuth), horizontal * std::sin(azimuth), z},
            reverse_digits(index, 5)};
}

std::uint32_t hash_pcg(std::uint32_t value) {
    const std::uint32_t state = value * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

/// A choice, and whether it is within the margin of the other way.
struct Choice {
    bool value = false;
    bool is_near = false;
};

Choice compare_below(double value, double limit) {
    return {value < limit, std::abs(value - limit) <= kSwitchMargin * std::abs(limit)};
}

bool is_near_texel_edge(double coordinate) {
    return std::abs(coordinate - std::round(coordinate)) <= kSwitchMargin;
}

class Evaluator {
  public:
    Evaluator(const Image& depth, const Image& normal, const Camera& camera,
              const HemisphereSsaoParams& params, std::uint32_t noise_seed)
        : m_depth(depth), m_normal(normal), m_params(params),
          m_tangents(compute_tangents(camera, depth.size())), m_noise_seed(noise_seed) {
        for (int i = 1; i <= params.samples; ++i) {
            m_samples.push_back(make_sample(i, params.directions));
        }
    }

    [[nodiscard]] OraclePixel evaluate(int x, int row) const {
        OraclePixel pixel;
        const double depth = static_cast<double>(m_depth.at(x, row));
        if (std::isinf(depth)) {
            return pixel;
        }
        const int y = m_depth.height() - 1 - row;
        const glm::dvec3 p =
            reconstruct({(x + 0.5) / m_depth.width(), (y + 0.5) / m_depth.height()}, depth);
        const glm::dvec3 n = glm::normalize(
            glm::dvec3(m_normal.at(x, row, 0), m_normal.at(x, row, 1), m_normal.at(x, row, 2)));
        const double s = n.z >= 0.0 ? 1.0 : -1.0;
        const double a = -1.0 / (s + n.z);
        const double b = n.x * n.y * a;
        const glm::dvec3 t0(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
        const glm::dvec3 b0(b, s + n.y * n.y * a, -n.y);
        const double angle = 2.0 * std::numbers::pi *
                             compute_oracle_turn(m_params.rotation, static_cast<std::uint32_t>(x),
                                                 static_cast<std::uint32_t>(y), m_noise_seed);
        const glm::dvec3 tangent = std::cos(angle) * t0 + std::sin(angle) * b0;
        const glm::dvec3 bitangent = std::cos(angle) * b0 - std::sin(angle) * t0;
        const double bias = m_params.bias * 0.5 *
                            (std::abs(n.x) * 2.0 * m_tangents.x / m_depth.width() +
                             std::abs(n.y) * 2.0 * m_tangents.y / m_depth.height()) /
                            std::abs(glm::dot(n, p));
        double blocked = 0.0;
        for (const Sample& sample : m_samples) {
            const glm::dvec3& d = sample.direction;
            const glm::dvec3 q =
                p + m_params.radius * sample.step * (d.x * tangent + d.y * bitangent + d.z * n);
            const double weight =
                m_params.directions == KernelDirections::uniform ? 2.0 * d.z : 1.0;
            const Choice hidden = is_hidden(p, q, bias);
            blocked += hidden.value ? weight : 0.0;
            pixel.flagged_weight += hidden.is_near ? weight : 0.0;
        }
        pixel.visibility = std::clamp(1.0 - blocked / m_params.samples, 0.0, 1.0);
        pixel.flagged_weight /= m_params.samples;
        return pixel;
    }

  private:
    [[nodiscard]] glm::dvec3 reconstruct(const glm::dvec2& uv, double depth) const {
        return {(2.0 * uv - 1.0) * m_tangents * depth, -depth};
    }

    /// The surface at the sample's texel hides it and lies within the cut. Near: any of the choices
    /// on the way is.
    [[nodiscard]] Choice is_hidden(const glm::dvec3& p, const glm::dvec3& q, double bias) const {
        const double depth_of_q = -q.z;
        if (depth_of_q <= 0.0) {
            return {false, depth_of_q >= kSwitchMargin * p.z};
        }
        glm::dvec2 uv = 0.5 + 0.5 * glm::dvec2(q) / depth_of_q / m_tangents;
        const glm::dvec2 size(m_depth.width(), m_depth.height());
        bool is_near = depth_of_q <= kSwitchMargin * -p.z;
        if (m_params.border == KernelBorder::open) {
            for (const double c : {uv.x, uv.y}) {
                if (c < -kSwitchMargin || c >= 1.0 + kSwitchMargin) {
                    return {false, is_near};
                }
                is_near = is_near || c <= kSwitchMargin || c >= 1.0 - kSwitchMargin;
                if (c < 0.0 || c >= 1.0) {
                    return {false, true};
                }
            }
        } else {
            uv = glm::clamp(uv, 0.5 / size, 1.0 - 0.5 / size);
        }
        const glm::dvec2 texel = uv * size;
        is_near = is_near || is_near_texel_edge(texel.x) || is_near_texel_edge(texel.y);
        const int row = m_depth.height() - 1 - static_cast<int>(texel.y);
        const auto surface = static_cast<double>(m_depth.at(static_cast<int>(texel.x), row));
        if (std::isinf(surface)) {
            return {false, is_near};
        }
        // 8 units in the last place of a float, as the shader allows itself.
        const double guard = 1.0 + 8.0 / 16777216.0;
        const Choice behind = compare_below(surface * (guard / depth_of_q + bias), 1.0);
        const glm::dvec3 to_hit = reconstruct(uv, surface) - p;
        const double cut = m_params.cut * m_params.radius;
        const Choice beyond = compare_below(cut * cut, glm::dot(to_hit, to_hit));
        return {behind.value && !beyond.value, is_near || behind.is_near || beyond.is_near};
    }

    const Image& m_depth;
    const Image& m_normal;
    HemisphereSsaoParams m_params;
    glm::dvec2 m_tangents;
    std::uint32_t m_noise_seed;
    std::vector<Sample> m_samples;
};

} // namespace

double compute_oracle_noise(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    return static_cast<double>(hash_pcg(x + hash_pcg(y + hash_pcg(seed))) >> 8) * 0x1p-24;
}

double compute_oracle_turn(KernelRotation rotation, std::uint32_t x, std::uint32_t y,
                           std::uint32_t seed) {
    // Row by row from the bottom: the ordered tile of 4x4 whose neighbours differ most.
    constexpr std::array<std::uint32_t, 16> kTile{0, 8,  2, 10, 12, 4, 14, 6,
                                                  3, 11, 1, 9,  15, 7, 13, 5};
    switch (rotation) {
    case KernelRotation::off:
        return 0.0;
    case KernelRotation::tile:
        return (kTile[(y % 4) * 4 + x % 4] ^ (hash_pcg(seed) % 16)) / 16.0;
    case KernelRotation::pixel:
        break;
    }
    return compute_oracle_noise(x, y, seed);
}

std::vector<OraclePixel> evaluate_oracle(const Image& depth, const Image& normal,
                                         const Camera& camera, const HemisphereSsaoParams& params,
                                         std::uint32_t noise_seed) {
    const Evaluator evaluator(depth, normal, camera, params, noise_seed);
    std::vector<OraclePixel> pixels;
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            pixels.push_back(evaluator.evaluate(x, y));
        }
    }
    return pixels;
}

} // namespace alcove
