#pragma once
// A furnished room without an opening, seen from inside. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit closed_room_unit();

} // namespace alcove
