#pragma once
// Elements of a glTF accessor, read with every bound checked.

#include "scenes/common/gltf_document.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace alcove {

/// Number of elements the accessor claims, after its bounds were checked against view and buffer.
/// Throws InputError.
[[nodiscard]] std::size_t count_elements(const GltfDocument& document, int accessor);

/// Float VEC3 elements, finite. Throws InputError on another type, on sparse and on normalised
/// accessors.
[[nodiscard]] std::vector<glm::vec3> read_vectors(const GltfDocument& document, int accessor);

/// Scalar u8, u16 or u32 elements, each less than `limit`. Throws InputError.
[[nodiscard]] std::vector<std::uint32_t> read_indices(const GltfDocument& document, int accessor,
                                                      std::size_t limit);

} // namespace alcove
