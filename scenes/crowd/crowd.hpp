#pragma once
// Knights who walk around a monument on a square. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit crowd_unit();

} // namespace alcove
