#pragma once
// Precision is two axes (DESIGN 2): how the depth test resolves, and how the eye depth is stored.

#include <string>
#include <string_view>

namespace alcove {

enum class RasterDepth { float32, unorm24, unorm16 };
/// from_raster: rebuilt from the raster depth, with all its quantisation.
enum class EyeDepth { float32, float16, from_raster };

struct Precision {
    RasterDepth raster_depth = RasterDepth::float32;
    bool reversed = false; ///< 1 at the near plane, 0 at the far plane
    EyeDepth eye_depth = EyeDepth::float32;
    friend bool operator==(const Precision&, const Precision&) = default;
};

/// "raster_depth=32F,eye_depth=32F" or "raster_depth=24,reversed,eye_depth=raster"
[[nodiscard]] std::string describe(const Precision& precision);
/// Reads "raster_depth=32F|24|16[,reversed],eye_depth=32F|16F|raster"; each part may be missing.
/// Throws InputError.
[[nodiscard]] Precision parse_precision(std::string_view text);

} // namespace alcove
