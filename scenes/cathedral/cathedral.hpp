#pragma once
// A procedural church interior in the manner of the Sibenik cathedral model. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit cathedral_unit();

} // namespace alcove
