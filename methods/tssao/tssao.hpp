#pragma once
// Temporal screen-space ambient occlusion: a history of each surface point's occlusion is
// reprojected, tested, and refined by a few samples a frame until it has as many as one pays for
// once. Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion using temporal
// coherence. Computer Graphics Forum 29(8), 2010.

#include "core/contract/method.hpp"
#include "methods/common/kernels.hpp"

namespace alcove {

enum class TssaoEstimator { hemisphere, fox_compton };
enum class TssaoDisocclusion { plane, relative, absolute, post_projective };
enum class TssaoInvalidation { smooth, full, none };
enum class TssaoConfidence { binary, graded };
enum class TssaoSmoothClamp { before, after };
enum class TssaoResolution { full, half };
enum class TssaoPacking { separate, packed };

/// Names say what a parameter controls; the paper's symbols stand in the table. Its c_adaptive
/// controls the filter and its c_spatial the number of samples.
struct TssaoParams {
    TssaoEstimator estimator = TssaoEstimator::hemisphere;
    double radius = 0.5;         ///< metres
    int initial_samples = 32;    ///< a frame
    int converged_samples = 8;   ///< a frame
    double history_cap = 1000.0; ///< samples; may be infinite
    double sample_switch_conv = 0.3;
    double rotation_off_conv = 0.5;
    double filter_off_conv = 0.2;
    int filter_radius = 2;      ///< pixels on each side; 0: no filter
    double filter_sigma = 0.25; ///< in radii
    bool use_history = true;
    TssaoDisocclusion disocclusion = TssaoDisocclusion::plane;
    double disocclusion_tolerance = 0.02;            ///< relative
    double disocclusion_distance = 0.1;              ///< metres
    double disocclusion_post_projective_step = 1e-4; ///< of a depth buffer over [0,1]
    TssaoInvalidation invalidation = TssaoInvalidation::smooth;
    TssaoConfidence confidence = TssaoConfidence::binary;
    double smooth_samples = 32.0;
    TssaoSmoothClamp smooth_clamp = TssaoSmoothClamp::before;
    double neighbourhood_tolerance = 0.02; ///< in radii
    bool test_near_plane = false;
    bool top_up = true;
    KernelDirections directions = KernelDirections::cosine;
    double cut = 2.0;  ///< in radii
    double bias = 1.0; ///< in half pixel footprints
    KernelBorder border = KernelBorder::open;
    double strength = 1.0; ///< factor on occlusion, behind the history
    double grazing_cosine = 0.1;
    TssaoResolution resolution = TssaoResolution::full;
    double guard = 0.0; ///< percent of width and height on each side
    TssaoPacking packing = TssaoPacking::separate;
};

/// Points of the sample table; indices run modulo it.
inline constexpr int kTssaoKernelLength = 2048;

/// Table 1 recommends caps of 500 to 1500; what convergence is held against without a cap.
inline constexpr double kTssaoLargestPublishedCap = 1500.0;

/// The declarations of TssaoParams.
[[nodiscard]] ParameterTable make_tssao_table();

/// Frames of a held camera until every pixel has reached the cap (1500 samples where it is
/// infinite); 0 without history.
[[nodiscard]] int count_tssao_warm_frames(const TssaoParams& params);

[[nodiscard]] MethodUnit tssao_unit();

} // namespace alcove
