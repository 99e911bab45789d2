#pragma once
// Volumetric obscurance by lines: for each point on a disc, the length of the view ray inside the
// ball that lies behind the depth buffer, against the length that could.

#include "core/contract/method.hpp"
#include "methods/common/estimator_method.hpp"
#include "methods/common/kernels.hpp"

namespace alcove {

enum class LineDomain { hemisphere, ball };
/// What a surface nearer than the ball says of its line.
enum class LineOutliers { solid, skipped, paired };

struct LineSamplingParams {
    double radius = 0.5; ///< metres
    int samples = 12;    ///< lines a pixel
    LineDomain domain = LineDomain::hemisphere;
    LineOutliers outliers = LineOutliers::paired;
    KernelRotation rotation = KernelRotation::tile;
    double strength = 1.0; ///< factor on occlusion
    KernelBorder border = KernelBorder::open;
    EstimatorResolution resolution = EstimatorResolution::full;
    int blur_radius = 3;    ///< pixels on each side; 0: no blur
    int upsample_width = 8; ///< pixels
    double blur_edge = 0.1; ///< in radii off the tangent plane
};

[[nodiscard]] MethodUnit line_sampling_unit();

} // namespace alcove
