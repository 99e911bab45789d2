#include "harness/run/scene_light.hpp"

#include "core/base/error.hpp"

#include <algorithm>

namespace alcove {
namespace {

constexpr const char* kEnvironment = "environment";

bool is_environment_file(const KeyValue& option) {
    return option.key == kEnvironment &&
           (option.value.ends_with(".hdr") || option.value.ends_with(".exr"));
}

} // namespace

bool is_lighting_key(std::string_view key) {
    const auto entries = lighting_table().entries();
    return std::any_of(entries.begin(), entries.end(),
                       [key](const auto& entry) { return entry.info.name == key; });
}

std::vector<std::string> list_lighting_keys() {
    std::vector<std::string> keys;
    for (const auto& entry : lighting_table().entries()) {
        keys.push_back(entry.info.name);
    }
    return keys;
}

std::optional<Lighting> read_lighting(const std::vector<KeyValue>& options,
                                      std::string_view where) {
    Lighting lighting;
    std::vector<ParameterOverride> overrides;
    bool is_lit = false;
    for (const KeyValue& option : options) {
        if (!is_lighting_key(option.key)) {
            continue;
        }
        is_lit = true;
        if (is_environment_file(option)) {
            lighting.environment_file = option.value;
        } else if (option.key == kEnvironment && option.value.find('/') != std::string::npos) {
            throw InputError(where, "is no environment file", option.value,
                             "a path that ends in .hdr or .exr");
        } else {
            overrides.push_back({option.key, option.value, Provenance::command_line});
        }
    }
    if (!is_lit) {
        return std::nullopt;
    }
    lighting.params =
        lighting_table().bind<LightingParams>(lighting_table().resolve(overrides, {}));
    return lighting;
}

std::string
resolve_lighting_value(const KeyValue& option,
                       const std::function<std::filesystem::path(const std::string&)>& resolve) {
    if (!is_environment_file(option)) {
        return option.value;
    }
    std::string path = resolve(option.value).string();
    if (path.find(',') != std::string::npos) {
        throw InputError(option.key, "a path with a comma cannot be told from options", path);
    }
    return path;
}

} // namespace alcove
