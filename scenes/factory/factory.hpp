#pragma once
// A hall of pipes and machines. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit factory_unit();

} // namespace alcove
