#pragma once
// What lag_frames and lag_share are made of: an older truth fitted to the test image.

#include "core/contract/temporal_metric.hpp"

namespace alcove {

struct LagParameters {
    double change = 0.02;
    int least_pixels = 64;
    double least_share = 0.05;
};

/// The table of both metrics, under the name of one.
[[nodiscard]] ParameterTable describe_lag_parameters(const std::string& metric);

/// test_t = (1 - share) ref_t + share warp(ref_(t-steps)), as near as it gets.
struct Lag {
    int steps = 1; ///< one of kEarlierSteps, even where the share is nothing
    double share = 0.0;
    bool is_late = false; ///< the share is above least_share and above three standard errors
};

struct LagFit {
    std::optional<Lag> plain;
    std::string undefined_reason; ///< where there is no `plain`
    std::optional<Lag> debiased;  ///< from cross products of the halves
};

/// Nothing before the sequence reaches back over all of kEarlierSteps: a fit that cannot see the
/// right step would name a wrong one.
[[nodiscard]] std::optional<LagFit> fit_lag(const TemporalFrame& frame,
                                            const LagParameters& parameters);

/// Planted: the newest of 16 frames holds (1 - share) ref_t + share ref_(t-steps) of a truth that
/// swings; its value is that of `metric`.
[[nodiscard]] double run_planted_lag(TemporalMetric& metric, double share, int steps);

} // namespace alcove
