#include "harness/run/scene_source.hpp"

#include "scenes/common/gltf_scene.hpp"

#include <filesystem>

namespace alcove {

bool is_scene_file(std::string_view name) {
    return name.ends_with(".gltf") || name.ends_with(".glb") ||
           name.find('/') != std::string_view::npos;
}

std::unique_ptr<Scene> open_scene(const Registry<SceneUnit>& scenes, const std::string& name,
                                  std::vector<std::string>& warnings) {
    std::unique_ptr<Scene> scene;
    if (is_scene_file(name)) {
        scene = open_gltf_scene(name, {}, &warnings);
    } else {
        const SceneUnit& unit = scenes.find(name);
        if (const std::optional<std::string> obstacle = unit.find_obstacle()) {
            throw InputError("scene " + name, *obstacle);
        }
        scene = unit.open(unit.parameters.resolve({}, {}));
    }
    check_scene(*scene, "scene " + name);
    return scene;
}

} // namespace alcove
