#pragma once
// Signed errors as colours.

#include "core/base/image.hpp"

namespace alcove {

/// test - reference of two visibility images, or of the Rec. 709 luminance of two pictures, as sRGB
/// codes: red = too dark (negative), blue = too bright, mid grey at 0; full colour at an error of
/// `range`.
[[nodiscard]] Image make_error_map(const Image& test, const Image& reference, float range = 0.5f);

} // namespace alcove
