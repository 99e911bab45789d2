#pragma once
// How the map of FLIP becomes numbers. This work is based on: Andersson, Nilsson, Shirley,
// Akenine-Moller. Visualizing and Communicating Errors in Rendered Images. 2021.

#include "metrics/common/pooled_region.hpp"

namespace alcove {

/// Puts the mean over counted pixels, summed in double, and as extras `weighted_median`,
/// `weighted_quartile_1`, `weighted_quartile_3`, `min` and `max` into a result, with the map and
/// the counts of the mask. A weighted quantile is where that share of the sum of all errors lies
/// below, from 100 bins of [0,1] weighted by their centres, straight inside a bin; 0 where all
/// errors are.
[[nodiscard]] MetricResult pool_flip_map(Image map, const Image* mask);

} // namespace alcove
