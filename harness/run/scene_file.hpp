#pragma once
// Anybody's scene: a .gltf, .glb or .off file by its path, with options.

#include "core/base/text.hpp"
#include "core/contract/scene.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// True for a specification of a file: its part before the options ends in .gltf, .glb or .off, or
/// has a slash.
[[nodiscard]] bool is_scene_file(std::string_view spec);

/// The path in a specification of a file.
[[nodiscard]] std::string get_scene_file(std::string_view spec);

/// Its options, lighting among them. Throws InputError on unknown keys (with the nearest) and keys
/// that stand twice.
[[nodiscard]] std::vector<KeyValue> list_scene_file_options(std::string_view spec);

/// "FILE[:walkthrough=W.json,animation=I,ao_radius=R,LIGHTING]" with every path passed through
/// `resolve`: against the current folder on the command line, inside the experiment's folder in
/// TOML. Throws InputError naming file and key on unknown keys (with the nearest), keys that stand
/// twice and values that are no numbers in range.
[[nodiscard]] std::string
resolve_scene_file(std::string_view spec,
                   const std::function<std::filesystem::path(const std::string&)>& resolve);

/// Opens a file. A licence.json beside it (licence.hpp) that does not let pictures be published
/// becomes a warning. Throws InputError as resolve_scene_file, open_gltf_scene and open_off_scene
/// do.
[[nodiscard]] std::unique_ptr<Scene> open_scene_file(std::string_view spec,
                                                     std::vector<std::string>& warnings);

/// Content hash of the file and of its walkthrough. Buffers and images beside it are not in it:
/// what they show decides, by hash_geometry, what is reused.
[[nodiscard]] std::string hash_scene_file(std::string_view spec);

} // namespace alcove
