#pragma once
// Lights of a glTF file (KHR_lights_punctual).

#include "core/contract/scene.hpp"
#include "scenes/common/gltf_document.hpp"
#include "scenes/common/gltf_nodes.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace alcove {

struct GltfLights {
    Lights lights;
    /// The nodes of those that move, as AnimatedSceneContent has them.
    std::vector<std::optional<std::size_t>> directional_nodes;
    std::vector<std::optional<std::size_t>> point_nodes;
};

/// The lights of the tree's nodes where they stand at `world` (a matrix a node), at most 4
/// directional and 4 points and spots, without shadow. Irradiance is colour times lux, intensity
/// colour times candela; where the brightest directional light, or the brightest point at a
/// distance of half of `diagonal_m` (the scene's, metres), gives an irradiance over 4, all of that
/// kind are scaled to make it 1, since nothing here has an exposure. The range of a point is not
/// looked at. Further lights are named in `warnings`. Throws InputError. Lights::ambient is left
/// to the caller.
[[nodiscard]] GltfLights read_lights(const GltfDocument& document, const GltfTree& tree,
                                     const std::vector<glm::dmat4>& world, double diagonal_m,
                                     GltfWarnings& warnings);

} // namespace alcove
