#pragma once
// A box that leaves the floor it stands on. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit lifted_box_unit();

} // namespace alcove
