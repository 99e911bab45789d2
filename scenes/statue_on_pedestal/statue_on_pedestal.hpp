#pragma once
// A statue on a moulded pedestal. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit statue_on_pedestal_unit();

} // namespace alcove
