#pragma once
// What the colours of a heatmap mean, as text with swatches.

#include <string>
#include <string_view>

namespace alcove {

/// Contents of a legend, without an element around it. `kind` is a key of the film's kinds or of
/// the accumulated maps (film.hpp); empty for pictures that need none. `film_frames` is the length
/// of the film, over which samples are summed.
[[nodiscard]] std::string make_heat_legend(std::string_view kind, int film_frames);

} // namespace alcove
