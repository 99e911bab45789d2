#pragma once
// What the depth buffer alone can say: rays marched pixel by pixel over one depth layer, whatever
// lies behind the first surface taken for solid to a constant thickness. Between a screen-space
// method's converged form and ray-traced truth it tells apart what the estimator leaves out and
// what the input does not hold (DESIGN 3.7). Slow on purpose.

#include "core/base/target.hpp"
#include "core/contract/method.hpp"

#include <limits>

namespace alcove {

struct ReferenceBruteForceParams {
    double radius = 0.5;                                        ///< metres
    int rays = 256;                                             ///< a pixel
    double step = 1.0;                                          ///< pixels of the screen
    int least_steps = 16;                                       ///< a ray
    double thickness = std::numeric_limits<double>::infinity(); ///< radii
    double bias = 1.0;                                          ///< half pixel footprints
    Falloff falloff = Falloff::linear;
    Weighting weighting = Weighting::cosine;
};

[[nodiscard]] MethodUnit reference_brute_force_unit();

} // namespace alcove
