#pragma once
// One glTF primitive as a mesh.

#include "core/contract/scene.hpp"
#include "scenes/common/gltf_document.hpp"

#include <optional>

namespace alcove {

/// Number of vertices its mesh will have, checked against the file but without reading it; nothing
/// if it does not consist of triangles. Throws InputError.
[[nodiscard]] std::optional<std::size_t> count_vertices(const GltfDocument& document, int mesh,
                                                        int primitive);

/// Reads a primitive that count_vertices counts. Throws InputError.
[[nodiscard]] Mesh read_primitive(const GltfDocument& document, int mesh, int primitive);

} // namespace alcove
