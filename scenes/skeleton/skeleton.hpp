#pragma once
// A walking skeleton before a far wall. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit skeleton_unit();

} // namespace alcove
