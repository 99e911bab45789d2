#pragma once
// Scenes by specification or by path.

#include "core/contract/scene.hpp"
#include "harness/run/scene_file.hpp"
#include "harness/run/scene_light.hpp"

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

/// A registered scene, all its parameters, and the light that it is shown in where the
/// specification says one (scene_light.hpp).
struct ChosenScene {
    SceneUnit unit;
    ResolvedParameters parameters;
    std::optional<Lighting> lighting;
};
/// Throws InputError with the nearest name on unknown scenes, parameters and choices, and on values
/// out of range.
[[nodiscard]] ChosenScene choose_scene(const Registry<SceneUnit>& scenes, std::string_view spec);

/// The specification with every path in it passed through `resolve`: resolve_scene_file, and the
/// file of an environment. Throws InputError.
[[nodiscard]] std::string
resolve_scene_paths(const std::string& spec,
                    const std::function<std::filesystem::path(const std::string&)>& resolve);

/// A registered scene by its specification, or anybody's glTF by its path (scene_file.hpp).
/// Warnings of the file go to `warnings`. Throws InputError as choose_scene does, and if the scene
/// cannot be opened here.
[[nodiscard]] std::unique_ptr<Scene> open_scene(const Registry<SceneUnit>& scenes,
                                                const std::string& spec,
                                                std::vector<std::string>& warnings);

} // namespace alcove
