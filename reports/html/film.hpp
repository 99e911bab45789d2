#pragma once
// The film of a round: which pictures it has, and what of it is seen without JavaScript.

#include "reports/analysis/analysis.hpp"
#include "reports/html/pictures.hpp"

#include <string>
#include <vector>

namespace alcove {

/// Kinds of pictures that every frame of the round's film can have.
[[nodiscard]] std::vector<PictureKind> list_film_kinds(const RoundRecord& round);

/// The player's place, legends, sheets of a few frames and the maps accumulated over the film;
/// empty if the round has no film.
[[nodiscard]] std::string make_film_block(const RoundAnalysis& round, const PictureFinder& finder);

} // namespace alcove
