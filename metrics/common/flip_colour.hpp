#pragma once
// The colour spaces of FLIP, and CIELAB, a row at a time, in planes. This work is based on:
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild. FLIP: A Difference Evaluator
// for Alternating Images. 2020, sections 4.1.1 to 4.1.3.

#include <array>
#include <cstddef>

namespace alcove {

/// sRGB codes, clamped to [0,1], to linear light (IEC 61966-2-1), in place.
void decode_codes(float* values, std::size_t count);

/// Linear RGB to y, cx, cz: Y / Yn, X / Xn - Y / Yn and Y / Yn - Z / Zn, the axes of YCxCz without
/// its factors 116, 500, 200 and without its offset, which filters that add up to 1 leave alone. In
/// place.
void convert_to_opponent(const std::array<float*, 3>& planes, std::size_t count);

/// Filtered y, cx, cz to CIELab under D65 with Hunt's effect (a, b times L / 100), over linear RGB
/// that is clamped to [0,1]. In place.
void convert_to_hunt_lab(const std::array<float*, 3>& planes, std::size_t count);

/// The same of grey: filtered y to L alone.
void convert_to_lightness(float* values, std::size_t count);

/// Linear RGB in [0,1] to CIELAB under D65 as it is (CIE 15), in place.
void convert_to_lab(const std::array<float*, 3>& planes, std::size_t count);

/// (|dL| + sqrt(da^2 + db^2))^0.7 of two rows of Hunt-Lab, mapped to [0,1] so that 0.4 of the
/// largest distance, green to blue, is 0.95 (equations 3 and 4). `planes` is 3, or 1 for grey. Uses
/// up test[0].
void compute_colour_error(const std::array<float*, 3>& test, const std::array<float*, 3>& reference,
                          int planes, std::size_t count, float* out);

} // namespace alcove
