#pragma once
// What mse, rmse and psnr are made of: sums of squared differences in double, and their noise.

#include "core/contract/metric.hpp"

namespace alcove {

struct SquaredError {
    double mean = 0.0;              ///< over all pixels and channels
    std::optional<double> debiased; ///< mean (t - a)(t - b) over the halves: its noise averages out
    std::optional<double>
        noise; ///< mean (a - b)^2 / 4: what the mean of the halves is off by itself
};

[[nodiscard]] SquaredError compute_squared_error(const MetricInput& input);

/// Squared difference a pixel, averaged over channels.
[[nodiscard]] Image make_squared_error_map(const MetricInput& input);

} // namespace alcove
