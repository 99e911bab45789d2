#pragma once
// All scenes, from the one list in scenes/CMakeLists.txt. registry.cpp is generated.

#include "core/base/registry.hpp"
#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] Registry<SceneUnit> scenes_registry();

} // namespace alcove
