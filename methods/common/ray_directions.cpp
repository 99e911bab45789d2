#include "methods/common/ray_directions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace alcove {
namespace {

constexpr unsigned kBundle = SobolBundles::kPoints;

/// cos and sin of 2 pi u for u in [0,1], within 1e-7: polynomials over an eighth of a turn to
/// either side of the nearest quarter. Without branches, so that a loop over lanes becomes one over
/// vectors, which it must be inlined for: one caller.
void compute_turn(float u, float& cosine, float& sine) {
    // floor(4 u + 1/2)
    const std::int32_t quarter = static_cast<std::int32_t>(8.0f * u + 1.0f) >> 1;
    const float a = (4.0f * u - static_cast<float>(quarter)) * (0.5f * std::numbers::pi_v<float>);
    const float b = a * a;
    const float s =
        a * (1.0f + b * (-1.0f / 6 + b * (1.0f / 120 + b * (-1.0f / 5040 + b * (1.0f / 362880)))));
    const float c = 1.0f + b * (-0.5f + b * (1.0f / 24 + b * (-1.0f / 720 + b * (1.0f / 40320))));
    const bool is_odd = (quarter & 1) != 0;
    const float x = is_odd ? s : c;
    const float y = is_odd ? c : s;
    cosine = ((quarter + 1) & 2) != 0 ? -x : x;
    sine = (quarter & 2) != 0 ? -y : y;
}

} // namespace

glm::mat3 make_frame(const glm::vec3& n) {
    const float s = std::copysign(1.0f, n.z);
    const float a = -1.0f / (s + n.z);
    const float b = n.x * n.y * a;
    return {glm::vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x),
            glm::vec3(b, s + n.y * n.y * a, -n.y), n};
}

BundleDirections make_directions(const SobolBundles::Points& points, Weighting weighting,
                                 const glm::mat3& frame) {
    alignas(64) std::array<float, kBundle> z;
    alignas(64) std::array<float, kBundle> horizontal;
    for (unsigned lane = 0; lane < kBundle; ++lane) {
        // Density cos / pi needs z = sqrt(1 - u), uniform density z = 1 - u; neither reaches the
        // horizon's z = 0.
        const float rest = 1.0f - points.x[lane];
        z[lane] = weighting == Weighting::cosine ? std::sqrt(rest) : rest;
        horizontal[lane] = std::sqrt(std::max(0.0f, 1.0f - z[lane] * z[lane]));
    }
    // A copy, so that the compiler sees that no store changes it: else there are no vectors.
    const std::array<glm::vec3, 3> axes{frame[0], frame[1], frame[2]};
    BundleDirections directions;
    for (unsigned lane = 0; lane < kBundle; ++lane) {
        float cosine = 0.0f;
        float sine = 0.0f;
        compute_turn(points.y[lane], cosine, sine);
        const float x = horizontal[lane] * cosine;
        const float y = horizontal[lane] * sine;
        directions.x[lane] = axes[0].x * x + axes[1].x * y + axes[2].x * z[lane];
        directions.y[lane] = axes[0].y * x + axes[1].y * y + axes[2].y * z[lane];
        directions.z[lane] = axes[0].z * x + axes[1].z * y + axes[2].z * z[lane];
    }
    return directions;
}

glm::vec3 make_cosine_direction(const glm::vec2& point, const glm::vec3& normal) {
    const float azimuth = 2.0f * std::numbers::pi_v<float> * point.y;
    const float horizontal = std::sqrt(point.x);
    return make_frame(normal) * glm::vec3(horizontal * std::cos(azimuth),
                                          horizontal * std::sin(azimuth),
                                          std::sqrt(1.0f - point.x));
}

} // namespace alcove
