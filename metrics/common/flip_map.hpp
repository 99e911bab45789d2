#pragma once
// The map of FLIP, what flip and hdr_flip are made of. This work is based on: Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom, Fairchild. FLIP: A Difference Evaluator for Alternating
// Images. 2020.

#include "core/base/image.hpp"

#include <array>
#include <functional>

namespace alcove {

/// Brings a row's planes (red, green, blue, or grey alone and two null pointers), `count` values
/// each, from what an image holds to linear light in [0,1]. Called from several threads.
using ToLinear = std::function<void(const std::array<float*, 3>& planes, std::size_t count)>;

/// FLIP of each pixel, in [0,1]. Images of one size with 1 or 3 channels; grey is colour with equal
/// channels. `pixels_per_degree` > 0. Borders repeat the outermost pixels.
[[nodiscard]] Image compute_flip_map(const Image& test, const Image& reference,
                                     double pixels_per_degree, const ToLinear& to_linear);

} // namespace alcove
