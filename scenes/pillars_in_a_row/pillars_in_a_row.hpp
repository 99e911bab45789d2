#pragma once
// A row of pillars before a wall: depth edges that a slow camera passes. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit pillars_in_a_row_unit();

} // namespace alcove
