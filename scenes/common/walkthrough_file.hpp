#pragma once
// walkthrough.json: a camera path as keys, from which one camera a frame is interpolated.
//
//   {"version": 1, "name": "default", "step_seconds": 0.03333333333333333, "frames": 120, "near":
//   0.05, "far": 100,
//    "cuts": [60],
//    "keys": [{"frame": 0, "position": [x, y, z], "target": [x, y, z], "up": [0, 1, 0],
//    "fov_y_degrees": 60}, ...]}
//
// Metres; cuts ascending, without frame 0, which always is one. The first key is frame 0, the last
// one frames - 1. Position and target run on cubic Hermite curves through the keys (tangents of the
// parabola through three neighbours), the field of view on a monotone cubic, up on a line. On a
// key's frame the camera is the key's, exactly. A cut at frame c needs keys at c - 1 and c: the
// curve is broken between them, so no frame lies in between two places. Curves may swing out
// between keys: keeping them clear of walls is the author's task.

#include "core/contract/scene.hpp"

#include <filesystem>
#include <string_view>

namespace alcove {

/// Reads the text of a walkthrough; `file` is what errors call it. Throws InputError naming file
/// and place, e.g. "walkthrough.json: keys[2].position", on unknown, missing or repeated keys,
/// wrong types, numbers beyond 1e9, more than 100,000 frames, frames that do not ascend and cameras
/// that see nothing.
[[nodiscard]] Walkthrough parse_walkthrough(std::string_view text, std::string_view file);

/// Same from a file of at most 16 MiB.
[[nodiscard]] Walkthrough read_walkthrough_file(const std::filesystem::path& path);

/// Same from a file that was compiled into the binary, e.g. "scenes/bunny/walkthrough.json".
/// Asserts that it was.
[[nodiscard]] Walkthrough get_embedded_walkthrough(std::string_view name);

} // namespace alcove
