#pragma once
// The tracks of walkthrough.json (see walkthrough_file.hpp).

#include "core/contract/scene.hpp"
#include "scenes/common/strict_json.hpp"

#include <cstdint>
#include <vector>

namespace alcove {

/// Reads an array of tracks; axes are normalised. Throws InputError naming the place, e.g.
/// "walkthrough.json: tracks[0].keys[2].frame".
[[nodiscard]] std::vector<ObjectTrack> read_walkthrough_tracks(const JsonPlace& place,
                                                               std::int64_t frames);

} // namespace alcove
