#pragma once
// How long a round will take, from two frames of it.

#include "core/gl/context.hpp"
#include "harness/run/units.hpp"
#include "reports/record/record.hpp"

namespace alcove {

struct RoundEstimate {
    std::size_t frames = 0; ///< of one replay
    double total_s = 0.0;   ///< all repeats and the capture
};

/// Opens the scene, compiles the round's methods, runs one timing repeat and one capture of the
/// first two frames, and multiplies by the frames of the plan; what histories need to converge is
/// added frame by frame. References are traced as if none were cached, unless they are. Rough: the
/// first frames stand for all. Throws what a run of the round throws.
[[nodiscard]] RoundEstimate estimate_round(gl::Context& context, const Units& units,
                                           const PlanRecord& plan, const RoundRecord& round);

} // namespace alcove
