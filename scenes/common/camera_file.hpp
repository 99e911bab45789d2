#pragma once
// CAM.json (DESIGN 4): one camera.
//
//   {"position":[x,y,z],"target":[x,y,z],"up":[x,y,z],"fov_y_degrees":f,"near":n,"far":f} metres

#include "core/base/camera.hpp"

#include <filesystem>
#include <string_view>

namespace alcove {

/// `file` is what errors call the text. Throws InputError naming file and place on unknown, missing
/// or repeated keys, wrong types, numbers beyond 1e9, and cameras that see nothing.
[[nodiscard]] Camera parse_camera(std::string_view text, std::string_view file);

/// Same from a file of at most 1 MiB.
[[nodiscard]] Camera read_camera_file(const std::filesystem::path& path);

} // namespace alcove
