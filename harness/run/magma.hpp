#pragma once
// The colours that published maps of FLIP use.

#include "core/base/image.hpp"

namespace alcove {

/// A map's values in magma as sRGB codes: entry round(255 v) of 256, v clamped to [0,1]. One
/// channel in, three out. This work is based on: van der Walt, Smith. mpl colormaps. 2015 (CC0).
[[nodiscard]] Image make_magma_map(const Image& values);

} // namespace alcove
