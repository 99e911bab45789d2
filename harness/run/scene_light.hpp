#pragma once
// Lighting as options of a scene's specification, beside the scene's own: "colour_blocks:
// environment=sky,shadows=true", "mine.glb:environment=studio.hdr".

#include "core/base/text.hpp"
#include "scenes/common/lighting.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// Is it a key of lighting_table()?
[[nodiscard]] bool is_lighting_key(std::string_view key);
[[nodiscard]] std::vector<std::string> list_lighting_keys();

/// From those options that are lighting keys; nothing if none is. Throws InputError naming `where`
/// on values out of range, with the nearest choice.
[[nodiscard]] std::optional<Lighting> read_lighting(const std::vector<KeyValue>& options,
                                                    std::string_view where);

/// The value of an option, with the path of an environment passed through `resolve`.
[[nodiscard]] std::string
resolve_lighting_value(const KeyValue& option,
                       const std::function<std::filesystem::path(const std::string&)>& resolve);

} // namespace alcove
