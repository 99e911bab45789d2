#pragma once
// A walking knight whose cloak deforms. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit paladin_unit();

} // namespace alcove
