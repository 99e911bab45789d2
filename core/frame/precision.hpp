#pragma once
// Precision: how the depth test resolves, and how the eye depth and the motion are stored.

#include <string>
#include <string_view>

namespace alcove {

enum class RasterDepth { float32, unorm24, unorm16 };
/// from_raster: rebuilt from the raster depth, with all its quantisation.
enum class EyeDepth { float32, float16, from_raster };
enum class MotionPrecision { float16, float32 };

struct Precision {
    RasterDepth raster_depth = RasterDepth::float32;
    bool reversed = false; ///< 1 at the near plane, 0 at the far plane
    EyeDepth eye_depth = EyeDepth::float32;
    MotionPrecision motion = MotionPrecision::float16;
    friend bool operator==(const Precision&, const Precision&) = default;
};

/// "raster_depth=32F,eye_depth=32F" or "raster_depth=24,reversed,eye_depth=raster,motion=32F";
/// the motion is named only where it is not 16F
[[nodiscard]] std::string describe(const Precision& precision);
/// Reads "raster_depth=32F|24|16[,reversed],eye_depth=32F|16F|raster,motion=16F|32F"; each part may
/// be missing. Throws InputError.
[[nodiscard]] Precision parse_precision(std::string_view text);

} // namespace alcove
