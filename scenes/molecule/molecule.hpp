#pragma once
// Overlapping balls, each an atom: many small convex occluders. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit molecule_unit();

} // namespace alcove
