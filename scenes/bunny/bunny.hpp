#pragma once
// The Stanford bunny on a floor. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit bunny_unit();

} // namespace alcove
