#pragma once
// The estimator of hemisphere_ssao restated in double precision, one sample after the other, from
// its formulas alone: the same points, the same noise, the same projection and nearest texel, and
// for each sample how near it is to switching.

#include "core/base/camera.hpp"
#include "methods/hemisphere_ssao/hemisphere_ssao.hpp"

#include <cstdint>
#include <vector>

namespace alcove {

/// How near a choice must be to falling the other way to be flagged: relative to the limit for
/// depths and distances, a share of a texel for the texel's edges, of the image for its border. The
/// shader's floats are off by some 5e-7 after projection.
inline constexpr double kSwitchMargin = 1e-5;

struct OraclePixel {
    double visibility = 1.0;
    double flagged_weight =
        0.0; ///< share of the pixel's weight on samples with a choice within the margin
};

/// pcg (Jarzynski, Olano 2020) of a pixel counted from the bottom left, in [0,1).
[[nodiscard]] double compute_oracle_noise(std::uint32_t x, std::uint32_t y, std::uint32_t seed);

/// Share of a full turn of a kernel at a pixel counted from the bottom left.
[[nodiscard]] double compute_oracle_turn(KernelRotation rotation, std::uint32_t x, std::uint32_t y,
                                         std::uint32_t seed);

/// One pixel after the other, row 0 on top. `depth` and `normal` hold what the textures hold.
[[nodiscard]] std::vector<OraclePixel> evaluate_oracle(const Image& depth, const Image& normal,
                                                       const Camera& camera,
                                                       const HemisphereSsaoParams& params,
                                                       std::uint32_t noise_seed);

} // namespace alcove
