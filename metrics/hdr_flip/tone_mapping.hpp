#pragma once
// The tone mappers of HDR-FLIP and the exposures that they call for. This work is based on:
// Andersson, Nilsson, Shirley, Akenine-Moller. Visualizing Errors in Rendered High Dynamic Range
// Images. 2021.

#include "core/base/image.hpp"

#include <array>

namespace alcove {

enum class ToneMapper { aces, hable, reinhard };

struct ExposureRange {
    double start = 0.0; ///< stops
    double stop = 0.0;
};

/// From where the largest luminance of an image of linear light is tone-mapped to 0.85 to where
/// its median is (section 4.2). Luminances below 2^-23 count as that.
[[nodiscard]] ExposureRange find_exposures(const Image& reference, ToneMapper mapper);

/// The fewest exposures that lie no more than about a stop apart: max(2, ceil(stop - start)),
/// evenly spaced with both ends.
[[nodiscard]] std::vector<double> list_exposures(ExposureRange range);

/// Scales a row's planes by 2^exposure, maps and clamps them to [0,1], in place. Grey has one plane
/// and two null pointers. Negative values count as 0.
void map_tones(const std::array<float*, 3>& planes, std::size_t count, double exposure,
               ToneMapper mapper);

} // namespace alcove
