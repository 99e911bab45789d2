#pragma once
// Any scene as a binary glTF 2.0 file.

#include "core/contract/scene.hpp"

#include <filesystem>
#include <set>
#include <string>

namespace alcove {

/// Writes one .glb, atomically: each mesh once, an object as a node with its mesh, albedo as base
/// colour factor, colours as COLOR_0, textures as PNG, lights as KHR_lights_punctual,
/// the walkthrough's camera. What moves becomes one animation with a key a frame of the
/// walkthrough, and one after it, so that the last frame is within the clip. All of it hangs on a
/// node at the scene's origin.
///
/// Returns what the file cannot hold, a line each: deforming objects stand as on frame 0, objects
/// that shear while they move stand still, a camera keeps its first angle of view, and the ambient
/// light is left out. Throws InputError if the file would be larger than 4 GiB, FailureError if it
/// cannot be written.
[[nodiscard]] std::set<std::string> export_gltf(const Scene& scene,
                                                const std::filesystem::path& path);

} // namespace alcove
