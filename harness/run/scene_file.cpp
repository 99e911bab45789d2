#include "harness/run/scene_file.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/hash.hpp"
#include "core/base/nearest_name.hpp"
#include "harness/run/scene_light.hpp"
#include "scenes/common/gltf_scene.hpp"
#include "scenes/common/licence.hpp"
#include "scenes/common/off_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace alcove {
namespace {

const std::array<std::string, 3> kKeys{"walkthrough", "animation", "ao_radius"};

bool has_scene_extension(std::string_view path) {
    return path.ends_with(".gltf") || path.ends_with(".glb") || path.ends_with(".off");
}

/// Length of the path in front of the options.
std::size_t find_path_end(std::string_view spec) {
    std::size_t end = std::string_view::npos;
    for (const std::string_view extension : {".gltf:", ".glb:", ".off:"}) {
        const std::size_t at = spec.find(extension);
        if (at != std::string_view::npos) {
            end = std::min(end, at + extension.size() - 1);
        }
    }
    if (end != std::string_view::npos) {
        return end;
    }
    return has_scene_extension(spec) ? spec.size() : std::min(spec.find(':'), spec.size());
}

GltfOptions parse_options(std::string_view spec) {
    constexpr std::int64_t kMostAnimations = 1'000'000;
    GltfOptions options;
    for (const KeyValue& option : list_scene_file_options(spec)) {
        const std::string where = get_scene_file(spec) + ": " + option.key;
        if (option.key == "walkthrough") {
            options.walkthrough = option.value;
        } else if (option.key == "animation") {
            const std::int64_t index = parse_integer(option.value, where);
            if (index < 0 || index > kMostAnimations) {
                throw InputError(where, "out of range", option.value, "0 or more");
            }
            options.animation = static_cast<int>(index);
        } else if (option.key == "ao_radius") {
            options.ao_radius_m = parse_number(option.value, where);
            if (!(*options.ao_radius_m > 0.0) || !std::isfinite(*options.ao_radius_m)) {
                throw InputError(where, "out of range", option.value,
                                 "a positive number of metres");
            }
        }
    }
    return options;
}

/// A licence that lies beside the file may forbid pictures of it.
void warn_of_licence(const std::filesystem::path& file, std::vector<std::string>& warnings) {
    const std::filesystem::path beside = file.parent_path() / kLicenceFile;
    if (!std::filesystem::exists(beside)) {
        return;
    }
    const Licence licence = read_licence(beside);
    if (!licence.figures) {
        warnings.push_back("pictures of " + file.filename().string() +
                           " may not be published: licence " + licence.spdx + ", " +
                           licence.attribution);
    }
}

} // namespace

bool is_scene_file(std::string_view spec) {
    const std::string_view path = spec.substr(0, find_path_end(spec));
    return has_scene_extension(path) || path.find('/') != std::string_view::npos;
}

std::string get_scene_file(std::string_view spec) {
    return std::string(spec.substr(0, find_path_end(spec)));
}

std::vector<KeyValue> list_scene_file_options(std::string_view spec) {
    const std::size_t end = find_path_end(spec);
    if (end == spec.size()) {
        return {};
    }
    const std::string file(spec.substr(0, end));
    std::vector<KeyValue> options = parse_key_values(spec.substr(end + 1), file);
    std::vector<std::string> keys = list_lighting_keys();
    keys.insert(keys.end(), kKeys.begin(), kKeys.end());
    for (std::size_t i = 0; i < options.size(); ++i) {
        const std::string& key = options[i].key;
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
            throw InputError(file, "unknown key", key, describe_choices(key, keys));
        }
        for (std::size_t k = 0; k < i; ++k) {
            if (options[k].key == key) {
                throw InputError(file, "key stands twice", key);
            }
        }
    }
    return options;
}

std::string
resolve_scene_file(std::string_view spec,
                   const std::function<std::filesystem::path(const std::string&)>& resolve) {
    // A wrong value shows before anything runs.
    static_cast<void>(parse_options(spec));
    static_cast<void>(read_lighting(list_scene_file_options(spec), get_scene_file(spec)));
    std::string resolved = resolve(get_scene_file(spec)).string();
    char separator = ':';
    for (const KeyValue& option : list_scene_file_options(spec)) {
        const std::string value = option.key == "walkthrough"
                                      ? resolve(option.value).string()
                                      : resolve_lighting_value(option, resolve);
        if (value.find(',') != std::string::npos) {
            throw InputError(get_scene_file(spec) + ": " + option.key,
                             "a path with a comma cannot be told from options", value);
        }
        resolved += separator + option.key + "=" + value;
        separator = ',';
    }
    return resolved;
}

std::unique_ptr<Scene> open_scene_file(std::string_view spec, std::vector<std::string>& warnings) {
    const std::string file = get_scene_file(spec);
    const GltfOptions options = parse_options(spec);
    warn_of_licence(file, warnings);
    if (!file.ends_with(".off")) {
        return open_gltf_scene(file, options, &warnings);
    }
    if (options.animation) {
        throw InputError(file + ": animation", "OFF files hold none");
    }
    return open_off_scene(file, {options.ao_radius_m, options.walkthrough});
}

std::string hash_scene_file(std::string_view spec) {
    Hasher hasher;
    hasher.add(read_file(get_scene_file(spec)));
    if (const auto walkthrough = parse_options(spec).walkthrough) {
        hasher.add(read_file(*walkthrough));
    }
    return hasher.finish_hex();
}

} // namespace alcove
