#pragma once
// A procedural city of 1.2 km with traffic, from 0.2 to 22 million vertices. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit city_unit();

} // namespace alcove
