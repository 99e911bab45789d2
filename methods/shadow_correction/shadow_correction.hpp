#pragma once
// All light of the scene by shadow maps of the method's own, with the shadows that the maps' bias
// swallows brought back in screen space; or by screen space alone.
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in
// image space. 2009, sections 4 and 5, figures 6 and 8 to 10.

#include "core/contract/method.hpp"
#include "methods/common/shadow_parameters.hpp"

#include <limits>

namespace alcove {

/// How far towards a light the screen is searched: the map's bias, or the radius.
enum class SegmentLength { bias, radius };

struct ShadowCorrectionParams {
    double radius = 0.5; ///< metres
    bool maps = true;
    int map_size = 1024; ///< texels a side
    MapBias bias = MapBias::clamped;
    double bias_scale = 1.5; ///< p / 2
    bool correction = true;
    SegmentLength segment = SegmentLength::bias;
    int correction_samples = 16;
    int layers = 1;
    double thickness = std::numeric_limits<double>::infinity(); ///< metres
    double screen_bias = 1.0;                                   ///< half pixel footprints
    int environment_lights = 0;
    int environment_map_size = 512; ///< texels a side
};

[[nodiscard]] MethodUnit shadow_correction_unit();

} // namespace alcove
