#include "harness/run/scene_source.hpp"

#include "core/base/text.hpp"

#include <algorithm>

namespace alcove {

SceneSpec parse_scene_spec(std::string_view text) {
    SceneSpec spec;
    const std::size_t colon = text.find(':');
    spec.name = text.substr(0, colon);
    if (colon == std::string_view::npos) {
        return spec;
    }
    for (const KeyValue& entry : parse_key_values(text.substr(colon + 1), "--scene")) {
        const bool is_known = std::any_of(
            spec.overrides.begin(), spec.overrides.end(),
            [&entry](const ParameterOverride& known) { return known.name == entry.key; });
        if (is_known) {
            throw InputError("--scene", "key stands twice", entry.key);
        }
        spec.overrides.push_back({entry.key, entry.value, Provenance::command_line});
    }
    return spec;
}

ChosenScene choose_scene(const Registry<SceneUnit>& scenes, std::string_view spec) {
    const SceneSpec parsed = parse_scene_spec(spec);
    const SceneUnit& unit = scenes.find(parsed.name);
    return {unit, unit.parameters.resolve(parsed.overrides, {})};
}

std::unique_ptr<Scene> open_scene(const Registry<SceneUnit>& scenes, const std::string& spec,
                                  std::vector<std::string>& warnings) {
    std::unique_ptr<Scene> scene;
    if (is_scene_file(spec)) {
        scene = open_scene_file(spec, warnings);
    } else {
        const ChosenScene chosen = choose_scene(scenes, spec);
        if (const std::optional<std::string> obstacle = chosen.unit.find_obstacle()) {
            throw InputError("scene " + chosen.unit.name, *obstacle);
        }
        scene = chosen.unit.open(chosen.parameters);
    }
    check_scene(*scene, "scene " + spec);
    return scene;
}

} // namespace alcove
