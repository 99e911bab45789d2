#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/nearest_name.hpp"
#include "harness/app/planned.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/scene_source.hpp"
#include "harness/run/units.hpp"
#include "scenes/common/gltf_export.hpp"
#include "scenes/common/walkthrough_writer.hpp"

#include <array>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

struct SceneFlags {
    std::string what;
    std::string scene;
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
    const std::unique_ptr<Scene> scene = open_scene(get_units().scenes, flags.scene, warnings);
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

int run_scene_verb(const SceneFlags& flags) {
    if (flags.what == "fetch") {
        throw_planned("scene fetch");
    }
    if (flags.what != "export") {
        const std::array<std::string, 1> kinds{"export"};
        throw InputError("scene", "unknown action", flags.what,
                         describe_choices(flags.what, kinds));
    }
    return export_scene(flags);
}

} // namespace

Action add_scene_verb(CLI::App& app) {
    auto flags = std::make_shared<SceneFlags>();
    app.add_option("what", flags->what, "export: as glTF, with the walkthrough beside it")
        ->required();
    app.add_option("scene", flags->scene, "NAME[:key=value,...], or a .gltf or .glb file")
        ->required();
    app.add_option("--out", flags->out, "FILE.glb");
    return [flags] { return run_scene_verb(*flags); };
}

} // namespace alcove
