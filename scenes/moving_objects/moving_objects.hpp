#pragma once
// A small stage on which everything moves, and camera moves over it at rest. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit moving_objects_unit();

} // namespace alcove
