#pragma once
// walkthrough.json: a camera path from which one camera a frame is made, what moves meanwhile, and
// what happens.
//
//   {"version": 2, "name": "default", "step_seconds": 0.03333333333333333, "frames": 120,
//    "near": 0.05, "far": 100, "cuts": [60], "interpolation": "keyed",
//    "keys": [{"frame": 0, "position": [x, y, z], "target": [x, y, z], "up": [0, 1, 0],
//              "fov_y_degrees": 60}, ...],
//    "events": [{"frame": 30, "label": "box lifts"}, ...],
//    "tracks": [{"object": "box", "pivot": [x, y, z], "axis": [x, y, z],
//                "keys": [{"frame": 30, "translation": [x, y, z], "degrees": 0}, ...]}, ...]}
//
// Metres and degrees. `cuts` ascend, without frame 0, which always is one: the camera's path is
// broken into runs between them. The cameras are `keys` with an `interpolation`, or `poses`:
//
//   "keyed"            every key has a frame; the first key is frame 0, the last one frames - 1,
//                      and a cut at frame c needs keys at c - 1 and c. See CameraCurve; two equal
//                      neighbouring keys hold the camera still.
//   "constant_speed"   only the first and the last key of a run state their frames. The position
//                      moves along the curve of a run at constant speed, target, up and field of
//                      view follow. Neighbouring keys stand apart. A run of one frame is one key.
//   "poses": [{"position", "target", "up", "fov_y_degrees"}, ...], one a frame, as they are.
//
// Curves may swing out between keys: keeping them clear of walls is the author's task.
// `events` ascend. `tracks` move objects at constant speed between their keys (ObjectTrack), at
// most one an object; an axis of any length is normalised. Both may be missing.

#include "core/contract/scene.hpp"

#include <filesystem>
#include <string_view>

namespace alcove {

inline constexpr int kWalkthroughVersion = 2;

/// Reads the text of a walkthrough; `file` is what errors call it. Throws InputError naming file
/// and place, e.g. "walkthrough.json: keys[2].position", on other versions, unknown, missing or
/// repeated keys, wrong types, numbers beyond 1e9, more than 100,000 frames, frames that do not
/// ascend and cameras that see nothing. That tracks name objects of the scene is checked by
/// check_scene.
[[nodiscard]] Walkthrough parse_walkthrough(std::string_view text, std::string_view file);

/// Same from a file of at most 16 MiB.
[[nodiscard]] Walkthrough read_walkthrough_file(const std::filesystem::path& path);

/// Same from a file that was compiled into the binary, e.g. "scenes/bunny/walkthrough.json".
/// Asserts that it was.
[[nodiscard]] Walkthrough get_embedded_walkthrough(std::string_view name);

} // namespace alcove
