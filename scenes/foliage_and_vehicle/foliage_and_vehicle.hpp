#pragma once
// A car on a road between trees. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit foliage_and_vehicle_unit();

} // namespace alcove
