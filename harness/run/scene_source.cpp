#include "harness/run/scene_source.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
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
    std::vector<std::string> names = list_lighting_keys();
    for (const auto& entry : unit.parameters.entries()) {
        names.push_back(entry.info.name);
    }
    std::vector<KeyValue> light;
    std::vector<ParameterOverride> own;
    for (const ParameterOverride& entry : parsed.overrides) {
        if (std::find(names.begin(), names.end(), entry.name) == names.end()) {
            throw InputError(parsed.name, "unknown parameter", entry.name,
                             describe_choices(entry.name, names));
        }
        if (is_lighting_key(entry.name)) {
            light.push_back({entry.name, entry.value});
        } else {
            own.push_back(entry);
        }
    }
    return {unit, unit.parameters.resolve(own, {}), read_lighting(light, "scene " + parsed.name)};
}

std::string
resolve_scene_paths(const std::string& spec,
                    const std::function<std::filesystem::path(const std::string&)>& resolve) {
    if (is_scene_file(spec)) {
        return resolve_scene_file(spec, resolve);
    }
    const SceneSpec parsed = parse_scene_spec(spec);
    std::string resolved = parsed.name;
    char separator = ':';
    for (const ParameterOverride& entry : parsed.overrides) {
        resolved += separator + entry.name + "=" +
                    resolve_lighting_value({entry.name, entry.value}, resolve);
        separator = ',';
    }
    return resolved;
}

std::unique_ptr<Scene> open_scene(const Registry<SceneUnit>& scenes, const std::string& spec,
                                  std::vector<std::string>& warnings) {
    std::unique_ptr<Scene> scene;
    std::optional<Lighting> lighting;
    if (is_scene_file(spec)) {
        scene = open_scene_file(spec, warnings);
        lighting = read_lighting(list_scene_file_options(spec), get_scene_file(spec));
    } else {
        const ChosenScene chosen = choose_scene(scenes, spec);
        if (const std::optional<std::string> obstacle = chosen.unit.find_obstacle()) {
            throw InputError("scene " + chosen.unit.name, *obstacle);
        }
        scene = chosen.unit.open(chosen.parameters);
        lighting = chosen.lighting;
    }
    if (lighting) {
        scene = relight(std::move(scene), *lighting);
    }
    check_scene(*scene, "scene " + spec);
    return scene;
}

} // namespace alcove
