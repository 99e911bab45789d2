#pragma once
// A statue that turns or slides on a plinth. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit statue_unit();

} // namespace alcove
