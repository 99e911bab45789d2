#pragma once
// What a method with history says of each pixel's past, for heatmaps and temporal metrics.

#include <array>
#include <string_view>

namespace alcove {

/// Why a pixel lost its history in this frame. The value is the number in the image.
enum class HistoryCause {
    kept,         ///< the history was used in full
    no_history,   ///< first frame of a segment: there was none
    off_screen,   ///< the point lay outside the previous image
    disocclusion, ///< the point was hidden, or another surface stands at its place
    neighbourhood ///< the point was visible, but what surrounds it has moved
};

inline constexpr std::array<std::string_view, 5> kHistoryCauseNames{
    "kept", "no_history", "off_screen", "disocclusion", "neighbourhood"};

/// Channels of a history state image, as methods write it and as metrics read it.
enum class HistoryChannel {
    convergence, ///< [0,1], after this frame's update; 1 = as converged as the method ever gets
    samples,     ///< taken for the pixel in this frame
    cause,       ///< a HistoryCause; 0 on the background
    surface      ///< 1 on surfaces, 0 on the background
};

} // namespace alcove
