#pragma once
// Pebbles on a plane: occluders that are small against everything. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit pebbles_unit();

} // namespace alcove
