#pragma once
// Colours and texture coordinates of a glTF primitive.

#include "core/contract/scene.hpp"
#include "scenes/common/gltf_document.hpp"
#include "scenes/common/gltf_texture.hpp"

#include <string>

namespace tinygltf {
struct Primitive;
} // namespace tinygltf

namespace alcove {

/// Fills albedo, colours, texture and texture coordinates of a mesh whose positions are read.
/// Colours beyond [0,1] are clamped with a warning. Throws InputError.
void read_surface(const GltfDocument& document, const tinygltf::Primitive& primitive,
                  const std::string& where, GltfTextures& textures, GltfWarnings& warnings,
                  Mesh& mesh);

} // namespace alcove
