#pragma once
// What missed_invalidation and false_invalidation are made of: what truth says of a pixel's past
// beside what the method did with its history.

#include "core/contract/temporal_metric.hpp"

namespace alcove {

/// What truth says of a pixel.
enum class Truth {
    unsure,   ///< between the two, or the background
    changed,  ///< the point was not visible one frame ago, or its reference is another
    unchanged ///< it was visible, and its reference is the same
};

/// Of warp(ref_(t-1)) - ref_t. Changed: |.|, and the distance of ref_t to the range of the 3 x 3
/// pixels of warp(ref_(t-1)), above `changed`; with halves, clear of the reference's noise
/// (find_change_threshold) and both of one sign and above half of it. Unchanged: |.| under
/// `unchanged`.
struct TruthThresholds {
    double changed = 0.02;
    double unchanged = 0.01;
    int least_pixels = 1; ///< with fewer such pixels the share is undefined
};

/// The share of surface pixels of which truth says `which` whose history was kept (`kept` true) or
/// not (false). Pixels whose cause is no_history are left out: there was nothing to keep. Nothing
/// on a first frame and for methods without history; undefined under `least_pixels`. Map: 1
/// where the pixel is one of the share, else 0. Throws InputError as check_temporal_frame does.
[[nodiscard]] std::optional<MetricResult> measure_history_share(const TemporalFrame& frame,
                                                                std::string_view metric,
                                                                const TruthThresholds& thresholds,
                                                                Truth which, bool kept);

/// The planted last frame of the checks, 40 x 30 pixels. Columns 0 to 9: disoccluded. Columns 10 to
/// 19: truth falls from 0.5 to 0.4. Columns 20 to 39: truth stays. Of each ten rows the first three
/// were kept, five lost to disocclusion, two had no history; gives `metric`'s value.
[[nodiscard]] double run_planted_invalidation(TemporalMetric& metric);

} // namespace alcove
