#pragma once
// statvo restated in double precision from its formulas alone: samples are added up one by one,
// without tables. Each decision that a float may take the other way is flagged.

#include "core/base/camera.hpp"
#include "methods/statvo/statvo.hpp"

#include <vector>

namespace alcove {

/// How near a choice must be to falling the other way to be flagged: in pixels for the rounding of
/// the box, in samples for an empty layer, in slices for a slice.
inline constexpr double kStatvoMargin = 2e-5;
/// For depths against the mean of a layer: metres that float32 may lose of the sum over a box. Sums
/// of an image of a thousand pixels at 4 m round to 2.4e-4, four of them make a box.
inline constexpr double kStatvoSumError = 1e-3;

struct StatvoPixel {
    double visibility = 1.0;
    bool is_near = false; ///< the pixel's own choices: the rounding of its box, an empty layer
    /// Of the samples in its box, those that might lie in another layer.
    double flagged_share = 0.0;
};

/// psi of equation (4).
[[nodiscard]] double compute_oracle_psi(double t, double drop);

/// One pixel after the other, row 0 on top. `hidden`: depths of the second layer, empty without.
/// `normal` holds what the texture holds.
[[nodiscard]] std::vector<StatvoPixel>
evaluate_statvo_oracle(const Image& depth, const Image& normal, const Image& hidden,
                       const Camera& camera, const StatvoParams& params);

} // namespace alcove
