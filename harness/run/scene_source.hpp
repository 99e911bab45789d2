#pragma once
// Scenes by specification or by path.

#include "core/contract/scene.hpp"
#include "harness/run/scene_file.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// "NAME[:key=value,...]" of a registered scene.
struct SceneSpec {
    std::string name;
    std::vector<ParameterOverride> overrides;
};
/// Throws InputError naming the part that cannot be read, or a key that stands twice. Names are
/// checked by choose_scene.
[[nodiscard]] SceneSpec parse_scene_spec(std::string_view text);

/// A registered scene and all its parameters.
struct ChosenScene {
    SceneUnit unit;
    ResolvedParameters parameters;
};
/// Throws InputError with the nearest name on unknown scenes, parameters and choices, and on values
/// out of range.
[[nodiscard]] ChosenScene choose_scene(const Registry<SceneUnit>& scenes, std::string_view spec);

/// A registered scene by its specification, or anybody's glTF by its path (scene_file.hpp).
/// Warnings of the file go to `warnings`. Throws InputError as choose_scene does, and if the scene
/// cannot be opened here.
[[nodiscard]] std::unique_ptr<Scene> open_scene(const Registry<SceneUnit>& scenes,
                                                const std::string& spec,
                                                std::vector<std::string>& warnings);

} // namespace alcove
