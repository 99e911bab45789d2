#pragma once
// Skins of a glTF file, and what binds vertices to them.

#include "scenes/common/animated_scene.hpp"
#include "scenes/common/gltf_document.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace tinygltf {
struct Primitive;
} // namespace tinygltf

namespace alcove {

/// JOINTS_n and WEIGHTS_n of a primitive called `where`, all sets, with weights that sum to 1.
/// Nothing without a set, and with a warning if weights cannot be normalised. Throws InputError.
[[nodiscard]] std::optional<SkinInfluences>
read_influences(const GltfDocument& document, const tinygltf::Primitive& primitive,
                std::size_t vertices, const std::string& where, GltfWarnings& warnings);

/// Skin `index`; `places` tells where each node of the file stands among the scene's nodes.
/// Nothing, with a warning, if a joint is not in the scene. Throws InputError.
[[nodiscard]] std::optional<Skin> read_skin(const GltfDocument& document, int index,
                                            std::span<const std::optional<std::size_t>> places,
                                            GltfWarnings& warnings);

/// Throws InputError naming `where` if a vertex follows a joint that the skin lacks.
void check_influences(const SkinInfluences& influences, const Skin& skin, const std::string& where);

} // namespace alcove
