#pragma once
// The smallest honest scene: what a newcomer copies. Never reported. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit template_scene_unit();

} // namespace alcove
