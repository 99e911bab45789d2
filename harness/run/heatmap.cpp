#include "harness/run/heatmap.hpp"

#include "core/base/history_state.hpp"

#include <algorithm>
#include <array>

namespace alcove {
namespace {

using Color = std::array<float, 3>;

void set_color(Image& map, int x, int y, const Color& color) {
    for (int c = 0; c < 3; ++c) {
        map.at(x, y, c) = color.at(static_cast<std::size_t>(c));
    }
}

float get(const Image& state, int x, int y, HistoryChannel channel) {
    return state.at(x, y, static_cast<int>(channel));
}

} // namespace

Image make_age_map(const Image& age, const Image& state) {
    constexpr Color kBackground{0.5f, 0.5f, 0.5f};
    constexpr Color kConverged{1.0f, 1.0f, 1.0f};
    Image map(age.size(), 3);
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const float recent = 1.0f - std::min(age.at(x, y) / kAgeOfBlack, 1.0f);
            Color color{recent, 0.1f * recent, 0.08f * recent};
            if (get(state, x, y, HistoryChannel::surface) == 0.0f) {
                color = kBackground;
            } else if (get(state, x, y, HistoryChannel::convergence) >= 1.0f) {
                color = kConverged;
            }
            set_color(map, x, y, color);
        }
    }
    return map;
}

Image make_cause_map(const Image& state) {
    constexpr std::array<Color, kHistoryCauseNames.size()> kColors{{
        {1.0f, 1.0f, 1.0f},
        {0.62f, 0.62f, 0.62f},
        {0.13f, 0.40f, 0.75f},
        {0.80f, 0.08f, 0.14f},
        {0.98f, 0.62f, 0.10f},
    }};
    Image map(state.size(), 3);
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const auto cause = static_cast<std::size_t>(get(state, x, y, HistoryChannel::cause));
            if (get(state, x, y, HistoryChannel::surface) != 0.0f) {
                set_color(map, x, y, kColors.at(cause));
            }
        }
    }
    return map;
}

Image make_scale_map(const Image& values, float range) {
    // Lightness rises evenly: CIE L* of about 0, 25, 55, 82, 100.
    constexpr std::array<Color, 5> kStops{{
        {0.0f, 0.0f, 0.0f},
        {0.31f, 0.11f, 0.44f},
        {0.83f, 0.34f, 0.30f},
        {0.99f, 0.78f, 0.40f},
        {1.0f, 1.0f, 1.0f},
    }};
    Image map(values.size(), 3);
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const float value = std::clamp(values.at(x, y) / range, 0.0f, 1.0f);
            const float place = value * static_cast<float>(kStops.size() - 1);
            const auto first = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
            const float weight = place - static_cast<float>(first);
            for (int c = 0; c < 3; ++c) {
                const auto i = static_cast<std::size_t>(c);
                map.at(x, y, c) =
                    (1.0f - weight) * kStops.at(first).at(i) + weight * kStops.at(first + 1).at(i);
            }
        }
    }
    return map;
}

} // namespace alcove
