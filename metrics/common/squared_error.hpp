#pragma once
// What mse, rmse and psnr are made of: sums of squared differences in double, and their noise.

#include "metrics/common/pooled_region.hpp"

namespace alcove {

struct SquaredError {
    double mean = 0.0;              ///< over all counted pixels and channels
    std::optional<double> debiased; ///< mean (t - a)(t - b) over the halves: its noise averages out
    std::optional<double>
        noise; ///< mean (a - b)^2 / 4: what the mean of the halves is off by itself
};

/// Asserts that the region, of the images' size, counts a pixel.
[[nodiscard]] SquaredError compute_squared_error(const MetricInput& input,
                                                 const PooledRegion& region);

/// Squared difference a pixel, averaged over channels.
[[nodiscard]] Image make_squared_error_map(const MetricInput& input);

} // namespace alcove
