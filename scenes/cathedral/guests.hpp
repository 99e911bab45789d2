#pragma once
// Who comes to the cathedral in its long walkthrough: a skeleton that walks the aisle, and the
// Stanford bunny far off in the choir.

#include "scenes/common/animated_scene.hpp"
#include "scenes/common/rigid_scene.hpp"

namespace alcove::cathedral {

/// The building with its guests. The bunny stays away where its npm package is missing. Asserts
/// that the building has no tracks.
[[nodiscard]] AnimatedSceneContent add_guests(RigidSceneContent building);

} // namespace alcove::cathedral
