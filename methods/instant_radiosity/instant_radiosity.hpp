#pragma once
// One bounce of the scene's lights by virtual point lights, each with a shadow map that the screen
// corrects, and a near bounce on screen in place of what their clamped form factor loses.
// This work is based on: Keller. Instant radiosity. 1997; Dachsbacher, Stamminger. Reflective
// shadow maps. 2005; Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image
// space. 2009, section 5, figures 11 and 12.

#include "core/contract/method.hpp"
#include "methods/common/shadow_parameters.hpp"

#include <limits>

namespace alcove {

/// The bounce of near surfaces on screen: none; only what the clamp takes from the virtual lights;
/// all of it, as published, which counts near surfaces twice.
enum class NearBounce { off, clamped_part, added };

struct InstantRadiosityParams {
    double radius = 0.5; ///< metres
    int vpls = 64;
    int rsm_size = 256;   ///< texels a side
    int map_size = 256;   ///< texels a side
    double angle = 150.0; ///< degrees
    double clamp = 0.5;   ///< metres
    MapBias bias = MapBias::clamped;
    double bias_scale = 1.5; ///< p / 2
    bool correction = true;
    int correction_samples = 8;
    int layers = 1;
    double thickness = std::numeric_limits<double>::infinity(); ///< metres
    double screen_bias = 1.0;                                   ///< half pixel footprints
    NearBounce near_bounce = NearBounce::clamped_part;
    int near_samples = 16;
    double near_strength = 1.0; ///< pi r_max^2 / N
    double near_clamp = 0.05;   ///< metres
    int tile = 4;               ///< pixels a side
    double fade = 0.8;          ///< share of the radius
    bool blur = true;
    double blur_edge = 0.1; ///< radii
};

[[nodiscard]] MethodUnit instant_radiosity_unit();

} // namespace alcove
