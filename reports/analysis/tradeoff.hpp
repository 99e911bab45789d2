#pragma once
// Time against accuracy over a run: for every scene and target the front of the cells that no other
// beats in both, with what is known of either, how long a method takes to reach a quality, and what
// others give for the same time or the same error. Nothing is interpolated: only cells that ran are
// compared.

#include "reports/analysis/analysis.hpp"

#include <array>

namespace alcove {

/// One cell. Rounds of one scene and target are joined through their anchors.
struct TradeoffPoint {
    std::string round;
    std::string cell;
    std::string label;
    std::string method;
    Estimate time;  ///< over the anchor's; 0 without interval for a cell without passes
    Estimate error; ///< mean over frames; the interval says how it spreads over content
    bool is_on_front = false;
    /// Another cell is better in both with intervals apart; the others may belong to the front.
    bool is_surely_beaten = false;
    /// Index of the best other method's cell that takes no more time, and of the fastest that has
    /// no more error; nothing if there is none.
    std::optional<std::size_t> equal_time;
    std::optional<std::size_t> equal_error;
};

/// Bounds of time-to-quality, over the smallest error of the group (under the largest, where higher
/// is better).
inline constexpr std::array kQualitySteps{1.1, 1.25, 1.5, 2.0};

/// Frames and time that a cell takes, from an empty history, to an error no larger than a bound.
struct TimeToQuality {
    double bound = 0.0;
    std::optional<int> frames;  ///< slowest of the bursts; nothing if one does not reach it
    std::optional<double> time; ///< those frames, in anchors
};

struct Tradeoff {
    std::string scene;
    std::string walkthrough;
    std::string target;
    std::string reference;
    int width = 0;
    int height = 0;
    std::string precision;
    bool warm = false;
    std::string metric;
    bool lower_is_better = true;
    SampleState state = SampleState::cold; ///< of the errors: converged where singles were replayed
    std::vector<TradeoffPoint> points;     ///< from fast to slow
    /// One list a point, one entry of kQualitySteps, the same bounds for all; empty without a burst
    /// that starts with an empty history.
    std::vector<std::vector<TimeToQuality>> to_quality;
};

/// The estimate's interval, or its extremes where it has none.
[[nodiscard]] Interval get_bounds(const Estimate& estimate);

/// One for every scene, walkthrough, target, size, precision, reference, start of histories and
/// choice of frames that has two cells or more with a time and an error. `metric` empty: the
/// round's front_metric.
[[nodiscard]] std::vector<Tradeoff> compute_tradeoffs(const RunAnalysis& run,
                                                      const std::string& metric = {});

} // namespace alcove
