#pragma once
// Bytes of a glTF file's buffer views and accessors, with every bound checked.

#include "scenes/common/gltf_document.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace tinygltf {
struct Accessor;
} // namespace tinygltf

namespace alcove {

/// Elements that stand `stride` bytes apart, in bounds.
struct ElementSpan {
    const unsigned char* data = nullptr;
    std::size_t stride = 0;
    std::size_t count = 0;
};

/// Throws InputError naming `user` (what refers to the view) if there is no such view, or the view
/// if it reaches beyond its buffer.
[[nodiscard]] std::span<const unsigned char> find_view(const GltfDocument& document, int view,
                                                       const std::string& user);

/// Throws InputError.
[[nodiscard]] const tinygltf::Accessor& find_accessor(const GltfDocument& document, int accessor);

/// What an accessor says of its elements; `view` is -1 for one that is all zeros but for its sparse
/// part. Throws InputError unless type and count are valid and the view holds all elements.
struct AccessorLayout {
    int component_type = 0;
    std::size_t component_bytes = 0;
    std::size_t components = 0;
    std::size_t count = 0;
    bool normalised = false;
    ElementSpan base; ///< without data where the view is missing
};
[[nodiscard]] AccessorLayout find_layout(const GltfDocument& document, int accessor);

/// Elements of `bytes` each, packed, from `offset` on. Throws InputError naming `where` unless the
/// view holds them.
[[nodiscard]] ElementSpan find_packed(const GltfDocument& document, int view, int offset,
                                      std::size_t bytes, std::size_t count,
                                      const std::string& where);

} // namespace alcove
