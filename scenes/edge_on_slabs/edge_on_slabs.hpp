#pragma once
// Thin slabs, level and upright, that a camera passes edge-on. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit edge_on_slabs_unit();

} // namespace alcove
