#pragma once
// Two feet on a floor: rounded toes and what lies between them and the floor. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit toes_unit();

} // namespace alcove
