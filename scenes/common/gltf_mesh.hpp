#pragma once
// One glTF primitive as a mesh, with what deforms it.

#include "scenes/common/animated_scene.hpp"
#include "scenes/common/gltf_document.hpp"
#include "scenes/common/gltf_texture.hpp"

#include <cstddef>
#include <optional>

namespace alcove {

struct GltfPrimitive {
    Mesh mesh;
    MeshDeformers deformers;
};

/// Number of vertices its mesh will have, checked against the file but without reading it; nothing
/// if it does not consist of triangles. Throws InputError.
[[nodiscard]] std::optional<std::size_t> count_vertices(const GltfDocument& document, int mesh,
                                                        int primitive);

/// Reads a primitive that count_vertices counts: POSITION, NORMAL (else flat), COLOR_0, the
/// texture coordinates of its base colour texture, JOINTS_n and WEIGHTS_n, morph targets. Throws
/// InputError.
[[nodiscard]] GltfPrimitive read_primitive(const GltfDocument& document, int mesh, int primitive,
                                           GltfTextures& textures, GltfWarnings& warnings);

/// Turns every triangle around, for objects of mirroring nodes.
void turn_triangles(GltfPrimitive& primitive);

} // namespace alcove
