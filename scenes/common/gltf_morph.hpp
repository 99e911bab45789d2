#pragma once
// Morph targets of a glTF primitive.

#include "scenes/common/gltf_document.hpp"
#include "scenes/common/morphing.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tinygltf {
struct Primitive;
} // namespace tinygltf

namespace alcove {

/// The displacements of all targets. `order` names, for each vertex of the mesh, the vertex of the
/// file it was made of. Throws InputError.
[[nodiscard]] std::vector<MorphTarget> read_morph_targets(const GltfDocument& document,
                                                          const tinygltf::Primitive& primitive,
                                                          std::span<const std::uint32_t> order,
                                                          std::size_t vertices,
                                                          const std::string& where);

} // namespace alcove
