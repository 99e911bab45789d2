#pragma once
// The Stanford bunny of the npm package `bunny` as a mesh.

#include "core/contract/scene.hpp"

#include <optional>
#include <string>

namespace alcove {

/// Why the bunny cannot be read here, with the command that mends it; nothing if it can.
[[nodiscard]] std::optional<std::string> find_bunny_obstacle();

/// 0.966 m high, with the middle of its footprint at zero and its lowest point on y = 0. Throws
/// InputError, which speaks of `where`, if the package is missing or damaged.
[[nodiscard]] Mesh read_bunny(std::string_view where);

} // namespace alcove
