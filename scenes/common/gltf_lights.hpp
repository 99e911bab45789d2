#pragma once
// Lights of a glTF file (KHR_lights_punctual).

#include "core/contract/scene.hpp"
#include "scenes/common/gltf_document.hpp"
#include "scenes/common/gltf_nodes.hpp"

#include <vector>

namespace alcove {

/// The directional lights of the tree's nodes where they stand at `world` (a matrix a node), at
/// most 4. Irradiance is colour times lux; where the brightest is over 4, all are scaled to make
/// it 1, since nothing here has an exposure. Point and spot lights, further ones and lights that
/// move are named in `warnings`. Throws InputError.
[[nodiscard]] std::vector<DirectionalLight> read_lights(const GltfDocument& document,
                                                        const GltfTree& tree,
                                                        const std::vector<glm::dmat4>& world,
                                                        GltfWarnings& warnings);

} // namespace alcove
