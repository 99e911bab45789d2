#pragma once
// The cameras of walkthrough.json (see walkthrough_file.hpp): keys or poses in, one pose a frame
// out.

#include "scenes/common/camera_curve.hpp"
#include "scenes/common/strict_json.hpp"

#include <cstdint>
#include <vector>

namespace alcove {

/// Reads "poses", or "keys" with "interpolation", of the file's root. `cuts` holds frame 0 and the
/// file's cuts, ascending. Throws InputError naming the place.
[[nodiscard]] std::vector<CameraPose>
read_walkthrough_cameras(const JsonPlace& root, std::int64_t frames, const std::vector<int>& cuts);

} // namespace alcove
