#include "metrics/common/invalidation.hpp"

#include "core/base/history_state.hpp"
#include "metrics/common/planted_sequence.hpp"
#include "metrics/common/truth_change.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

constexpr std::size_t kStateChannels = 4;

/// How far a value lies outside the range of an image's valid pixels around `i`.
double get_distance_to_range(const Image& image, const Image& valid, std::size_t i, float value) {
    const int width = image.width();
    const int x = static_cast<int>(i) % width;
    const int y = static_cast<int>(i) / width;
    float low = value;
    float high = value;
    bool is_first = true;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height() - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
            if (valid.at(u, v) != 0.0f) {
                low = is_first ? image.at(u, v) : std::min(low, image.at(u, v));
                high = is_first ? image.at(u, v) : std::max(high, image.at(u, v));
                is_first = false;
            }
        }
    }
    return static_cast<double>(std::max({low - value, value - high, 0.0f}));
}

Truth judge(const TemporalFrame& frame, std::size_t i, const TruthThresholds& thresholds) {
    const EarlierFrame& earlier = frame.earlier.front();
    if (frame.surface.values()[i] == 0.0f) {
        return Truth::unsure;
    }
    if (earlier.correspondence.appeared.values()[i] != 0.0f) {
        return Truth::changed;
    }
    if (earlier.correspondence.valid.values()[i] == 0.0f) {
        return Truth::unsure;
    }
    const auto change =
        static_cast<double>(earlier.reference.values()[i] - frame.reference.values()[i]);
    if (std::abs(change) < thresholds.unchanged) {
        return Truth::unchanged;
    }
    // Where occlusion varies from pixel to pixel, interpolation alone changes it.
    if (std::abs(change) <= thresholds.changed ||
        get_distance_to_range(earlier.reference, earlier.correspondence.valid, i,
                              frame.reference.values()[i]) <= thresholds.changed) {
        return Truth::unsure;
    }
    if (frame.reference_a == nullptr || !earlier.reference_a) {
        return Truth::changed;
    }
    const auto a =
        static_cast<double>(earlier.reference_a->values()[i] - frame.reference_a->values()[i]);
    const auto b =
        static_cast<double>(earlier.reference_b->values()[i] - frame.reference_b->values()[i]);
    const bool agree =
        (a > 0.0) == (b > 0.0) && std::min(std::abs(a), std::abs(b)) > 0.5 * std::abs(change);
    return agree ? Truth::changed : Truth::unsure;
}

} // namespace

std::optional<MetricResult> measure_history_share(const TemporalFrame& frame,
                                                  std::string_view metric,
                                                  const TruthThresholds& thresholds, Truth which,
                                                  bool kept) {
    check_temporal_frame(frame, metric);
    if (frame.earlier.empty() || frame.history_state == nullptr) {
        return std::nullopt;
    }
    ALCOVE_ASSERT(frame.earlier.front().steps == 1, "the frame before");
    TruthThresholds clear = thresholds;
    clear.changed = static_cast<double>(
        find_change_threshold(frame, frame.earlier.first(1), thresholds.changed));
    MetricResult result;
    result.map = Image(frame.test.size(), 1);
    const float* state = frame.history_state->values().data();
    std::size_t asked = 0;
    std::size_t found = 0;
    for (std::size_t i = 0; i < frame.test.values().size(); ++i) {
        const float cause =
            state[kStateChannels * i + static_cast<std::size_t>(HistoryChannel::cause)];
        if (judge(frame, i, clear) != which ||
            cause == static_cast<float>(HistoryCause::no_history)) {
            continue;
        }
        ++asked;
        if ((cause == static_cast<float>(HistoryCause::kept)) == kept) {
            ++found;
            result.map->values()[i] = 1.0f;
        }
    }
    if (asked < static_cast<std::size_t>(std::max(thresholds.least_pixels, 1))) {
        result.undefined_reason = std::string("truth ") +
                                  (which == Truth::changed ? "changes" : "stays") + " at " +
                                  std::to_string(asked) + " points with a history, " +
                                  std::to_string(thresholds.least_pixels) + " are needed";
        return result;
    }
    result.value = static_cast<double>(found) / static_cast<double>(asked);
    return result;
}

double run_planted_invalidation(TemporalMetric& metric) {
    constexpr ImageSize kSize{40, 30};
    std::vector<PlantedFrame> frames(2, make_planted_frame(kSize, PlantedMotion::still));
    PlantedFrame& last = frames.back();
    last.history_state = Image(kSize, kStateChannels);
    for (int y = 0; y < kSize.height; ++y) {
        const HistoryCause cause = y % 10 < 3   ? HistoryCause::kept
                                   : y % 10 < 8 ? HistoryCause::disocclusion
                                                : HistoryCause::no_history;
        for (int x = 0; x < kSize.width; ++x) {
            last.to_previous.valid.at(x, y) = x < 10 ? 0.0f : 1.0f;
            last.to_previous.appeared.at(x, y) = x < 10 ? 1.0f : 0.0f;
            last.reference.at(x, y) = x >= 10 && x < 20 ? 0.4f : 0.5f;
            last.history_state->at(x, y, static_cast<int>(HistoryChannel::cause)) =
                static_cast<float>(cause);
        }
    }
    return get_last_planted_value(metric, frames);
}

} // namespace alcove
