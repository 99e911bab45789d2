#pragma once
// Red, blue and yellow blocks on a light floor: what colours travel to their neighbours. See
// README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit colour_blocks_unit();

} // namespace alcove
