#pragma once
// What temporal_flicker and flicker_ratio are made of: the error of this frame, the last frame's
// error warped to here, and their difference.

#include "core/contract/temporal_metric.hpp"

namespace alcove {

/// Means of squares (or of cross products) over the pixels that are surface and were visible one
/// frame ago.
struct ErrorMeans {
    double change = 0.0;  ///< of D = e_t - warp(e_(t-1))
    double now = 0.0;     ///< of e_t
    double earlier = 0.0; ///< of warp(e_(t-1))
};

struct ErrorStep {
    std::size_t pixels = 0; ///< where 0, the means are 0 and say nothing
    ErrorMeans plain;
    std::optional<ErrorMeans> debiased; ///< of A's error times B's; only with halves
    std::optional<ErrorMeans> noise;    ///< of half of A's error minus B's; only with halves
    Image change_map;                   ///< |D|, 0 outside the pixels
};

/// Keeps the last frame's error.
class ErrorSteps {
  public:
    void reset() { m_previous.reset(); }
    /// Nothing on a sequence's first frame.
    [[nodiscard]] std::optional<ErrorStep> add(const TemporalFrame& frame);

  private:
    std::optional<Image> m_previous; ///< channels: e and, with halves, e_A and e_B
};

} // namespace alcove
