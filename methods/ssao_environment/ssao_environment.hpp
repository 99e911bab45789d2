#pragma once
// What directional occlusion is compared with: the mean visibility of the same samples times one
// lookup of the prefiltered surroundings.
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in
// image space. 2009, table 1 and figure 3 (their SSAO).

#include "core/base/target.hpp"
#include "core/contract/method.hpp"
#include "methods/common/kernels.hpp"

namespace alcove {

/// What the mean visibility is multiplied on.
enum class DimmedLight { surroundings, all };

struct SsaoEnvironmentParams {
    double radius = 0.5; ///< metres
    int samples = 16;    ///< a pixel
    int tile = 4;        ///< pixels a side; tile^2 sets
    Weighting weighting = Weighting::uniform;
    DimmedLight dimmed = DimmedLight::surroundings;
    double fade = 0.8; ///< share of the radius
    KernelBorder border = KernelBorder::open;
    double bias = 1.0; ///< half pixel footprints
    bool blur = true;
    double blur_edge = 0.1; ///< radii
};

[[nodiscard]] MethodUnit ssao_environment_unit();

} // namespace alcove
