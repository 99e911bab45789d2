#pragma once
// The filters of FLIP, all separable. This work is based on: Andersson, Nilsson, Akenine-Moller,
// Oskarsson, Astrom, Fairchild. FLIP: A Difference Evaluator for Alternating Images. 2020,
// sections 4.1.1 and 4.2.1.

#include <vector>

namespace alcove {

/// One half of a filter along one axis: the weight of the centre, then those at distance 1, 2, ...
struct HalfFilter {
    std::vector<float> weights;
    [[nodiscard]] int radius() const { return static_cast<int>(weights.size()) - 1; }
};

struct FlipFilters {
    // Contrast sensitivity, each channel's sum over the plane normalised to 1.
    HalfFilter achromatic;
    HalfFilter red_green;
    HalfFilter blue_yellow_wide; ///< the channel is the sum of both filters' results
    HalfFilter blue_yellow_narrow;
    // Features; odd filters change sign with the side.
    HalfFilter gaussian;
    HalfFilter first_derivative;  ///< odd, each lobe's sum is +-1
    HalfFilter second_derivative; ///< even, each lobe's sum is +-1
};

/// For `pixels_per_degree` of visual angle.
[[nodiscard]] FlipFilters make_flip_filters(double pixels_per_degree);

} // namespace alcove
