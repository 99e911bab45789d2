#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/nearest_name.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/scene_fetch.hpp"
#include "harness/run/scene_source.hpp"
#include "harness/run/units.hpp"
#include "scenes/common/gltf_export.hpp"
#include "scenes/common/walkthrough_writer.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

struct SceneFlags {
    std::string what;
    std::vector<std::string> scenes;
    std::string out;
};

void print_warning(const std::string& warning) {
    fmt::print(stderr, "alcove: warning: {}\n", warning);
}

int export_scene(const SceneFlags& flags) {
    const std::filesystem::path out(flags.out);
    if (out.extension() != ".glb") {
        throw InputError("--out", "not a binary glTF file", flags.out, "a name that ends in .glb");
    }
    std::vector<std::string> warnings;
    const std::unique_ptr<Scene> scene =
        open_scene(get_units().scenes, flags.scenes.front(), warnings);
    for (const std::string& warning : warnings) {
        print_warning(warning);
    }
    for (const std::string& warning : export_gltf(*scene, out)) {
        print_warning(warning);
    }
    // What the tracks move is the file's animation.
    Walkthrough walkthrough = scene->get_walkthrough();
    walkthrough.tracks.clear();
    const std::filesystem::path beside =
        std::filesystem::path(out).replace_extension(".walkthrough.json");
    write_file_atomically(beside, write_walkthrough(walkthrough));
    const SceneSize size = count_size(*scene);
    fmt::print("{}: {} meshes, {} objects, {} triangles, {} frames\n{}: the walkthrough\n",
               flags.out, scene->get_meshes().size(), scene->get_objects().size(), size.triangles,
               walkthrough.cameras.size(), beside.string());
    return 0;
}

void list_fetchable() {
    for (const FetchableScene& scene : list_fetchable_scenes()) {
        const std::string needs = scene.needs_blender ? ", needs Blender" : "";
        fmt::print("{:14} {}; {} from {}{}; licence {}\n", scene.name,
                   is_fetched(scene) ? get_fetched_file(scene).string() : "not fetched",
                   scene.title, scene.npm.empty() ? scene.debian : scene.npm, needs,
                   scene.licence.spdx);
    }
    fmt::print("alcove scene fetch NAME... | all\n");
}

int fetch(const SceneFlags& flags) {
    if (flags.scenes.empty()) {
        list_fetchable();
        return 0;
    }
    std::vector<FetchableScene> chosen;
    for (const std::string& name : flags.scenes) {
        if (name == "all") {
            chosen = list_fetchable_scenes();
            break;
        }
        chosen.push_back(find_fetchable_scene(name));
    }
    fetch_scenes(chosen, [](const std::string& step) { fmt::print(stderr, "{}\n", step); });
    for (const FetchableScene& scene : chosen) {
        fmt::print("alcove run --scene {}\n", get_fetched_file(scene).string());
        if (!scene.licence.figures) {
            print_warning("pictures of " + scene.name + " may not be published: licence " +
                          scene.licence.spdx + ", " + scene.licence.attribution);
        }
    }
    return 0;
}

int run_scene_verb(const SceneFlags& flags) {
    if (flags.what == "fetch") {
        return fetch(flags);
    }
    if (flags.what != "export") {
        const std::array<std::string, 2> kinds{"export", "fetch"};
        throw InputError("scene", "unknown action", flags.what,
                         describe_choices(flags.what, kinds));
    }
    if (flags.scenes.size() != 1) {
        throw InputError("scene export", "takes one scene", std::to_string(flags.scenes.size()));
    }
    return export_scene(flags);
}

} // namespace

Action add_scene_verb(CLI::App& app) {
    auto flags = std::make_shared<SceneFlags>();
    app.add_option("what", flags->what,
                   "export: as glTF, with the walkthrough beside it; fetch: models from packages, "
                   "into the cache")
        ->required();
    app.add_option("scenes", flags->scenes,
                   "export: NAME[:key=value,...], or a file; fetch: names, all, or nothing for a "
                   "list");
    app.add_option("--out", flags->out, "FILE.glb");
    return [flags] { return run_scene_verb(*flags); };
}

} // namespace alcove
