#include "harness/run/scene_fetch.hpp"

#include "core/base/cache_folder.hpp"
#include "core/base/embedded_file.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/nearest_name.hpp"
#include "harness/run/piped_process.hpp"
#include "scenes/common/strict_json.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace alcove {

/// fetchable_scenes.json, from cmake/embed_files.cmake.
std::span<const EmbeddedFile> embedded_catalogue();

namespace {

namespace fs = std::filesystem;

FetchableScene read_item(const JsonPlace& place) {
    place.check_keys({"name", "title", "files", "licence"},
                     {"debian", "npm", "archive", "blender"});
    FetchableScene scene;
    const auto read = [&place](std::string_view key) {
        return place.has(key) ? place.get(key).read_text() : std::string();
    };
    scene.name = read("name");
    scene.title = read("title");
    scene.debian = read("debian");
    scene.npm = read("npm");
    scene.archive = read("archive");
    scene.needs_blender = place.has("blender") && place.get("blender").read_truth();
    const JsonPlace files = place.get("files");
    for (std::size_t i = 0; i < files.count(); ++i) {
        scene.files.push_back(
            {files.at(i).get("from").read_text(), files.at(i).get("as").read_text()});
    }
    scene.licence = parse_licence(place.get("licence"));
    return scene;
}

/// A folder that is gone when its owner is.
class WorkFolder {
  public:
    explicit WorkFolder(fs::path path) : m_path(std::move(path)) {
        fs::remove_all(m_path);
        create_output_folder(m_path);
    }
    ~WorkFolder() {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return m_path; }

  private:
    fs::path m_path;
};

/// Runs a script of the shell in `folder`; names reach it as $1, $2, ... and are never read as
/// script. Returns what the programs said last on standard error; throws FailureError with it if
/// one fails.
std::string run_script(const fs::path& folder, const std::string& what, const std::string& script,
                       const std::vector<std::string>& names) {
    const fs::path log = folder / "log";
    std::vector<std::string> arguments{"-euc", "cd \"$1\"; shift; " + script, "sh",
                                       folder.string()};
    arguments.insert(arguments.end(), names.begin(), names.end());
    PipedProcess process("/bin/sh", arguments, log);
    while (process.read_line()) {
    }
    if (process.finish().exit_code != 0) {
        throw FailureError(what, "failed", process.read_log());
    }
    return process.read_log();
}

void require(const char* program, const std::string& why) {
    const char* path = std::getenv("PATH");
    const std::string folders = path != nullptr ? path : "";
    for (std::size_t begin = 0; begin <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', begin), folders.size());
        if (access((fs::path(folders.substr(begin, end - begin)) / program).c_str(), X_OK) == 0) {
            return;
        }
        begin = end + 1;
    }
    throw InputError("scene fetch", std::string(program) + " is missing", {}, why);
}

/// Downloaded packages, each once.
class Packages {
  public:
    explicit Packages(fs::path folder) : m_folder(std::move(folder)) {}

    /// The folder that holds it, as package.deb or package.tgz.
    const fs::path& get(const FetchableScene& scene,
                        const std::function<void(const std::string&)>& say) {
        const std::string& name = scene.npm.empty() ? scene.debian : scene.npm;
        const auto known = m_folders.find(name);
        if (known != m_folders.end()) {
            return known->second;
        }
        say("downloading " + name);
        const fs::path folder = m_folder / std::to_string(m_folders.size());
        create_output_folder(folder);
        if (scene.npm.empty()) {
            require("apt-get", "a Debian-like system");
            require("dpkg-deb", "a Debian-like system");
            run_script(folder, "apt-get download " + name,
                       "apt-get -q download \"$1\" >&2; mv ./*.deb package.deb", {name});
        } else {
            require("npm", "Node's package manager");
            run_script(folder, "npm pack " + name,
                       "npm pack --silent \"$1\" >&2; mv ./*.tgz package.tgz", {name});
        }
        return m_folders.emplace(name, folder).first->second;
    }

  private:
    fs::path m_folder;
    std::map<std::string, fs::path> m_folders;
};

void extract(const FetchableScene& scene, const FetchableFile& file, const fs::path& package,
             const fs::path& target) {
    const std::string what = "unpacking " + file.from;
    if (!scene.npm.empty()) {
        run_script(package, what, "tar -xzO -f package.tgz \"$1\" > \"$2\"",
                   {file.from, target.string()});
    } else if (!scene.archive.empty()) {
        run_script(package, what,
                   "dpkg-deb --fsys-tarfile package.deb | tar -xO \"./$1\" | tar -xzO \"$2\" > "
                   "\"$3\"",
                   {scene.archive, file.from, target.string()});
    } else {
        run_script(package, what, "dpkg-deb --fsys-tarfile package.deb | tar -xO \"./$1\" > \"$2\"",
                   {file.from, target.string()});
    }
    if (!fs::exists(target) || fs::file_size(target) == 0) {
        throw FailureError(what, "is not in the package", scene.debian + scene.npm);
    }
}

/// Debian's exporter needs no scene of its own: the file's is exported whole.
void export_blend(const fs::path& folder, const fs::path& blend, const fs::path& glb) {
    const std::string said =
        run_script(folder, "blender " + blend.filename().string(),
                   "blender --background --factory-startup \"$1\" --python-expr \"import bpy, sys; "
                   "bpy.ops.export_scene.gltf(filepath=sys.argv[-1])\" -- \"$2\" >&2",
                   {blend.string(), glb.string()});
    if (!fs::exists(glb)) {
        throw FailureError("blender", "exported nothing (it needs python3-numpy)", said);
    }
}

} // namespace

const std::vector<FetchableScene>& list_fetchable_scenes() {
    static const std::vector<FetchableScene> kScenes = [] {
        const EmbeddedFile& file = embedded_catalogue().front();
        const nlohmann::json json = parse_strict_json(file.text, file.name);
        const JsonPlace root(json, std::string(file.name));
        const JsonPlace items = root.get("items");
        std::vector<FetchableScene> scenes;
        for (std::size_t i = 0; i < items.count(); ++i) {
            scenes.push_back(read_item(items.at(i)));
        }
        return scenes;
    }();
    return kScenes;
}

const FetchableScene& find_fetchable_scene(std::string_view name) {
    std::vector<std::string> names;
    for (const FetchableScene& scene : list_fetchable_scenes()) {
        if (scene.name == name) {
            return scene;
        }
        names.push_back(scene.name);
    }
    throw InputError("scene fetch", "unknown scene", name, describe_choices(name, names));
}

fs::path get_fetched_file(const FetchableScene& scene) {
    return get_fetched_scenes_folder() / scene.name / scene.files.front().as;
}

bool is_fetched(const FetchableScene& scene) {
    return fs::exists(get_fetched_file(scene));
}

void fetch_scenes(std::span<const FetchableScene> scenes,
                  const std::function<void(const std::string&)>& say) {
    const fs::path folder = get_fetched_scenes_folder();
    const WorkFolder work(folder / (".fetching-" + std::to_string(getpid())));
    Packages packages(work.path());
    for (const FetchableScene& scene : scenes) {
        if (is_fetched(scene)) {
            continue;
        }
        if (std::getenv("ALCOVE_NO_INSTALL") != nullptr) {
            throw InputError("scene fetch", "ALCOVE_NO_INSTALL forbids package managers",
                             scene.name, "the file at " + get_fetched_file(scene).string());
        }
        if (scene.needs_blender) {
            require("blender", "Blender, which exports " + scene.name);
        }
        const fs::path& package = packages.get(scene, say);
        const fs::path partial = work.path() / scene.name;
        create_output_folder(partial);
        for (const FetchableFile& file : scene.files) {
            if (scene.needs_blender) {
                const fs::path blend = package / "source.blend";
                extract(scene, file, package, blend);
                say("exporting " + scene.name);
                export_blend(package, blend, partial / file.as);
            } else {
                extract(scene, file, package, partial / file.as);
            }
        }
        write_file_atomically(partial / kLicenceFile, write_licence(scene.licence));
        publish_folder(partial, folder / scene.name);
        say("fetched " + scene.name);
    }
}

} // namespace alcove
