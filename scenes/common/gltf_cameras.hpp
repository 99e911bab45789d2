#pragma once
// The walkthrough of a glTF file that comes without one.

#include "core/contract/scene.hpp"
#include "scenes/common/bounds.hpp"
#include "scenes/common/gltf_document.hpp"
#include "scenes/common/gltf_nodes.hpp"

namespace alcove {

/// Looks through each perspective camera of the scene, with a cut between two, while the nodes
/// move: for 60 frames or as long as the clip lasts. Without a camera, and with a warning, it
/// circles the bounds in 120 frames or as long. 100,000 frames at most, with a warning. Throws
/// InputError on cameras that see nothing.
[[nodiscard]] Walkthrough make_gltf_walkthrough(const GltfDocument& document, const GltfTree& tree,
                                                double duration_s, const Bounds& bounds,
                                                GltfWarnings& warnings);

} // namespace alcove
