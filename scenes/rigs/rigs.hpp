#pragma once
// The analytic scenes of a blog on artefacts of ambient occlusion, one by its parameter. See
// README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit rigs_unit();

} // namespace alcove
