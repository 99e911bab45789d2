#include "methods/common/sample_sets.hpp"

#include "core/base/assert.hpp"
#include "methods/common/sobol.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace alcove {
namespace {

constexpr std::uint32_t kDirectionSeed = 0x51ed270bu;
constexpr std::uint32_t kLengthSeed = 0x2c1b3c6du;

} // namespace

std::vector<glm::vec4> make_sample_sets(int tile, int samples) {
    ALCOVE_ASSERT(tile >= 1 && samples >= 1, "a tile and samples");
    std::vector<glm::vec4> points;
    const int count = tile * tile * samples;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const auto index = static_cast<std::uint32_t>(i);
        const glm::vec2 direction = compute_scrambled_sobol(index, kDirectionSeed);
        const float height = direction.x;
        const float horizontal = std::sqrt(1.0f - height * height);
        const float azimuth = 2.0f * std::numbers::pi_v<float> * direction.y;
        points.emplace_back(horizontal * std::cos(azimuth), horizontal * std::sin(azimuth), height,
                            compute_scrambled_sobol(index, kLengthSeed).x);
    }
    return points;
}

std::string make_sample_set_counts(int tile, int samples) {
    return "const int kTile = " + std::to_string(tile) +
           ";\nconst int kSamples = " + std::to_string(samples) + ";\n";
}

} // namespace alcove
