#pragma once
// A method whose image is a function of what it is shown, on the CPU: sound, or with one fault.

#include "core/contract/method.hpp"

#include <functional>
#include <string>

namespace alcove {

struct PlantedParams {
    double radius = 0.5;
    double cap = 1000.0;
    int samples = 16;
};

/// One frame as a plant sees it; the image starts as 1 everywhere.
struct PlantedFrame {
    const FrameView& view;
    const Image& depth;
    const Image& normal;
    const PlantedParams& params;
    int frames_since_reset = 0; ///< from 0
    bool has_moved = false;     ///< the camera did, since the last reset
    bool has_seen_nan = false;  ///< in the depth, since the last reset
};
using Plant = std::function<void(const PlantedFrame& frame, Image& visibility)>;

/// With a radius, a history whose cap has the symbol n_max, and a preset `converged`; its plane
/// response is 1.
[[nodiscard]] MethodUnit make_planted_unit(Plant plant);

/// Sets all surface pixels (finite depth) to `value`.
void darken_surfaces(const PlantedFrame& frame, Image& visibility, float value);

} // namespace alcove
