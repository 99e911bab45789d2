#include "harness/run/history_record.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

float get(const Image& state, int x, int y, HistoryChannel channel) {
    return state.at(x, y, static_cast<int>(channel));
}

HistoryCause get_cause(const Image& state, int x, int y) {
    return static_cast<HistoryCause>(static_cast<int>(get(state, x, y, HistoryChannel::cause)));
}

} // namespace

const std::vector<HistoryNumberInfo>& list_history_numbers() {
    static const std::vector<HistoryNumberInfo> kNumbers{
        {"history_invalidated", "Pixels that lost history", "share",
         "Share of surface pixels whose history was dropped or cut in this frame, whatever the "
         "cause."},
        {"history_no_history", "... without any", "share", "Because the sequence begins."},
        {"history_off_screen", "... off screen", "share",
         "Because the point lay outside the previous image."},
        {"history_disocclusion", "... disoccluded", "share",
         "Because another surface stood at the point's place."},
        {"history_neighbourhood", "... neighbourhood", "share",
         "Because what surrounds the point has moved."},
        {"history_converged", "Converged pixels", "share",
         "Share of surface pixels whose history is full."},
        {"history_convergence", "Mean convergence", "share",
         "Mean over surface pixels of samples in the history over its cap."},
        {"history_samples", "Samples a pixel", "samples",
         "Mean over surface pixels of the samples taken in this frame."},
        {"history_age", "Mean age", "frames",
         "Mean over surface pixels of the frames since the point last lost history; sequences "
         "only."},
    };
    return kNumbers;
}

Image fit_history_state(const Image& state, ImageSize size) {
    const int scale = state.width() < size.width ? 2 : 1;
    // Half of what is larger than the image, in its pixels; an odd full size leaves one pixel over.
    const int border_x = (state.width() * scale - size.width) / 2;
    const int border_y = (state.height() * scale - size.height) / 2;
    ALCOVE_ASSERT(border_x >= 0 && border_y >= 0, "a state as large as the image, or half of it");
    Image fitted(size, state.channels());
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (int c = 0; c < state.channels(); ++c) {
                // Textures begin at the bottom: an odd height lacks its last row at the top.
                const int from_bottom = (size.height - 1 - y + border_y) / scale;
                fitted.at(x, y, c) =
                    state.at((x + border_x) / scale, state.height() - 1 - from_bottom, c);
            }
        }
    }
    return fitted;
}

std::vector<HistoryNumber> count_history(const Image& state, const Image* age) {
    double surfaces = 0.0;
    std::array<double, kHistoryCauseNames.size()> causes{};
    double converged = 0.0;
    double convergence = 0.0;
    double samples = 0.0;
    double ages = 0.0;
    for (int y = 0; y < state.height(); ++y) {
        for (int x = 0; x < state.width(); ++x) {
            if (get(state, x, y, HistoryChannel::surface) == 0.0f) {
                continue;
            }
            surfaces += 1.0;
            causes.at(static_cast<std::size_t>(get_cause(state, x, y))) += 1.0;
            const float value = get(state, x, y, HistoryChannel::convergence);
            converged += value >= 1.0f ? 1.0 : 0.0;
            convergence += value;
            samples += get(state, x, y, HistoryChannel::samples);
            ages += age != nullptr ? age->at(x, y) : 0.0;
        }
    }
    if (surfaces == 0.0) {
        return {};
    }
    std::vector<HistoryNumber> numbers{
        {"history_invalidated", 1.0 - causes[0] / surfaces},
        {"history_no_history", causes[1] / surfaces},
        {"history_off_screen", causes[2] / surfaces},
        {"history_disocclusion", causes[3] / surfaces},
        {"history_neighbourhood", causes[4] / surfaces},
        {"history_converged", converged / surfaces},
        {"history_convergence", convergence / surfaces},
        {"history_samples", samples / surfaces},
    };
    if (age != nullptr) {
        numbers.push_back({"history_age", ages / surfaces});
    }
    return numbers;
}

void HistoryRecord::reset() {
    m_age = Image();
    m_invalidations = Image();
    m_samples = Image();
    m_frames = 0;
}

void HistoryRecord::add(const Image& state, const Correspondence* to_previous) {
    const ImageSize size = state.size();
    const bool is_first = m_age.empty() || to_previous == nullptr;
    if (m_samples.empty()) {
        m_samples = Image(size, 1);
        m_invalidations = Image(size, 1);
    }
    Image age(size, 1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            m_samples.at(x, y) += get(state, x, y, HistoryChannel::samples);
            const bool is_kept = get_cause(state, x, y) == HistoryCause::kept;
            if (is_first || get(state, x, y, HistoryChannel::surface) == 0.0f) {
                continue;
            }
            if (!is_kept) {
                m_invalidations.at(x, y) += 1.0f;
                continue;
            }
            float before = 0.0f;
            if (to_previous->appeared.at(x, y) == 0.0f) {
                const int old_x =
                    std::clamp(static_cast<int>(std::floor(to_previous->position.at(x, y, 0))), 0,
                               size.width - 1);
                const int old_y =
                    std::clamp(static_cast<int>(std::floor(to_previous->position.at(x, y, 1))), 0,
                               size.height - 1);
                before = m_age.at(old_x, old_y);
            }
            age.at(x, y) = before + 1.0f;
        }
    }
    m_frames += is_first ? 0 : 1;
    m_age = std::move(age);
}

Image HistoryRecord::compute_invalidated_share() const {
    Image share = m_invalidations;
    for (float& value : share.values()) {
        value /= static_cast<float>(std::max(m_frames, 1));
    }
    return share;
}

} // namespace alcove
