#pragma once
// Scenes by name or by path.

#include "core/contract/scene.hpp"

#include <memory>
#include <string>

namespace alcove {

/// True for a path to a .gltf or .glb file.
[[nodiscard]] bool is_scene_file(std::string_view name);

/// A registered scene with its defaults, or anybody's glTF. Warnings of the file go to `warnings`.
/// Throws InputError with the nearest name.
[[nodiscard]] std::unique_ptr<Scene> open_scene(const Registry<SceneUnit>& scenes,
                                                const std::string& name,
                                                std::vector<std::string>& warnings);

} // namespace alcove
