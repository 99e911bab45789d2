#include "metrics/common/truth_change.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

/// mean ((x_A - x_B) / 2)^2 for x = warp(ref_(t-k)) - ref_t; 0 where no pixel is valid.
double compute_noise(const TemporalFrame& frame, const EarlierFrame& earlier) {
    const float* surface = frame.surface.values().data();
    const float* valid = earlier.correspondence.valid.values().data();
    const float* a = frame.reference_a->values().data();
    const float* b = frame.reference_b->values().data();
    const float* earlier_a = earlier.reference_a->values().data();
    const float* earlier_b = earlier.reference_b->values().data();
    const std::size_t count = frame.test.values().size();
    double sum = 0.0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (surface[i] != 0.0f && valid[i] != 0.0f) {
            const float half = 0.5f * ((earlier_a[i] - earlier_b[i]) - (a[i] - b[i]));
            sum += static_cast<double>(half * half);
            ++pixels;
        }
    }
    return pixels > 0 ? sum / static_cast<double>(pixels) : 0.0;
}

} // namespace

float find_change_threshold(const TemporalFrame& frame, std::span<const EarlierFrame> earlier,
                            double wanted) {
    double threshold = wanted;
    for (const EarlierFrame& then : earlier) {
        if (frame.reference_a != nullptr && then.reference_a) {
            threshold = std::max(threshold, kClearOfNoise * std::sqrt(compute_noise(frame, then)));
        }
    }
    return static_cast<float>(threshold);
}

} // namespace alcove
