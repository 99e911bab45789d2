#pragma once
// Elements of a glTF accessor as floats or indices: strided, sparse, normalised or quantised, with
// every bound checked.

#include "scenes/common/gltf_document.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// Which numbers a place of the format takes besides float.
enum class GltfNumbers {
    real,        ///< none
    normalised,  ///< 8 and 16 bit integers that stand for [0,1] or [-1,1]
    quantised,   ///< with KHR_mesh_quantization: those, and plain 8 and 16 bit integers
    quantised_uv ///< normalised without the extension, plain integers with it
};

/// Number of elements the accessor claims, after its bounds were checked against view and buffer.
/// Throws InputError.
[[nodiscard]] std::size_t count_elements(const GltfDocument& document, int accessor);

/// Numbers an element has: 1 to 4 for SCALAR and VECn, 16 for MAT4. Throws InputError.
[[nodiscard]] std::size_t count_components(const GltfDocument& document, int accessor);

/// All numbers of an accessor with `components` an element, finite. Integers that are normalised
/// are divided by their largest (glTF 2.0, 3.11); sparse values are put in place. Throws InputError
/// on other types and component types, and on sparse parts that do not ascend or lie outside.
[[nodiscard]] std::vector<float> read_numbers(const GltfDocument& document, int accessor,
                                              std::size_t components, GltfNumbers numbers);

/// Same, as vectors.
[[nodiscard]] std::vector<glm::vec2> read_pairs(const GltfDocument& document, int accessor,
                                                GltfNumbers numbers);
[[nodiscard]] std::vector<glm::vec3> read_vectors(const GltfDocument& document, int accessor,
                                                  GltfNumbers numbers);

/// Unsigned integers of `components` an element (8 or 16 bits; scalars 32 as well), each less than
/// `limit`. Throws InputError.
[[nodiscard]] std::vector<std::uint32_t> read_indices(const GltfDocument& document, int accessor,
                                                      std::size_t components, std::size_t limit);

} // namespace alcove
