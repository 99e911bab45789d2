#include "scenes/common/gltf_accessor.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include <tiny_gltf.h>

namespace alcove {
namespace {

/// Bytes of an accessor, in bounds.
struct ElementSpan {
    const unsigned char* data = nullptr;
    std::size_t stride = 0;
    std::size_t count = 0;
};

const tinygltf::Accessor& find_accessor(const GltfDocument& document, int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= document.model->accessors.size()) {
        throw InputError(document.name("accessors", index), "no such accessor", {},
                         "less than " + std::to_string(document.model->accessors.size()));
    }
    return document.model->accessors[static_cast<std::size_t>(index)];
}

ElementSpan find_elements(const GltfDocument& document, int index) {
    const tinygltf::Accessor& accessor = find_accessor(document, index);
    const tinygltf::Model& model = *document.model;
    const std::string where = document.name("accessors", index);
    if (accessor.sparse.isSparse) {
        throw InputError(where + ".sparse", "sparse accessors are not supported");
    }
    if (accessor.normalized) {
        throw InputError(where + ".normalized", "normalised accessors are not supported");
    }
    if (accessor.bufferView < 0 ||
        static_cast<std::size_t>(accessor.bufferView) >= model.bufferViews.size()) {
        throw InputError(where + ".bufferView", "no such buffer view",
                         std::to_string(accessor.bufferView),
                         "less than " + std::to_string(model.bufferViews.size()));
    }
    const auto view_index = static_cast<std::size_t>(accessor.bufferView);
    const tinygltf::BufferView& view = model.bufferViews[view_index];
    const std::string view_where = document.name("bufferViews", accessor.bufferView);
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) {
        throw InputError(view_where + ".buffer", "no such buffer", std::to_string(view.buffer),
                         "less than " + std::to_string(model.buffers.size()));
    }
    const std::size_t buffer_size =
        model.buffers[static_cast<std::size_t>(view.buffer)].data.size();
    if (view.byteOffset > buffer_size || view.byteLength > buffer_size - view.byteOffset) {
        throw InputError(view_where, "reaches beyond its buffer",
                         std::to_string(view.byteOffset) + " + " + std::to_string(view.byteLength),
                         "at most " + std::to_string(buffer_size));
    }
    const int component =
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    const int components =
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    if (component <= 0 || components <= 0 || accessor.count == 0) {
        throw InputError(where, "type, component type or count is invalid");
    }
    const std::size_t element =
        static_cast<std::size_t>(component) * static_cast<std::size_t>(components);
    if (view.byteStride != 0 && (view.byteStride < element || view.byteStride > 252 ||
                                 view.byteStride % static_cast<std::size_t>(component) != 0)) {
        throw InputError(view_where + ".byteStride", "invalid", std::to_string(view.byteStride),
                         std::to_string(element) + " to 252, a multiple of " +
                             std::to_string(component));
    }
    const std::size_t stride = view.byteStride != 0 ? view.byteStride : element;
    // No sum can overflow: each side is bounded by the view's length before it is used.
    if (accessor.byteOffset > view.byteLength || element > view.byteLength - accessor.byteOffset ||
        accessor.count - 1 > (view.byteLength - accessor.byteOffset - element) / stride) {
        throw InputError(where, "reaches beyond its buffer view",
                         std::to_string(accessor.count) + " elements at byte " +
                             std::to_string(accessor.byteOffset),
                         "at most " + std::to_string(view.byteLength) + " bytes");
    }
    const unsigned char* data = model.buffers[static_cast<std::size_t>(view.buffer)].data.data();
    return {data + view.byteOffset + accessor.byteOffset, stride, accessor.count};
}

} // namespace

std::size_t count_elements(const GltfDocument& document, int accessor) {
    return find_elements(document, accessor).count;
}

std::vector<glm::vec3> read_vectors(const GltfDocument& document, int index) {
    const tinygltf::Accessor& accessor = find_accessor(document, index);
    const std::string where = document.name("accessors", index);
    if (accessor.type != TINYGLTF_TYPE_VEC3 ||
        accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
        throw InputError(where, "positions and normals are read as float VEC3 only",
                         "type " + std::to_string(accessor.type) + ", component type " +
                             std::to_string(accessor.componentType));
    }
    const ElementSpan span = find_elements(document, index);
    std::vector<glm::vec3> vectors(span.count);
    for (std::size_t i = 0; i < span.count; ++i) {
        std::array<float, 3> v{};
        std::memcpy(v.data(), span.data + i * span.stride, sizeof(v));
        if (!std::all_of(v.begin(), v.end(), [](float value) { return std::isfinite(value); })) {
            throw InputError(where, "element " + std::to_string(i) + " is not finite");
        }
        vectors[i] = {v[0], v[1], v[2]};
    }
    return vectors;
}

std::vector<std::uint32_t> read_indices(const GltfDocument& document, int index,
                                        std::size_t limit) {
    const tinygltf::Accessor& accessor = find_accessor(document, index);
    const std::string where = document.name("accessors", index);
    const int type = accessor.componentType;
    if (accessor.type != TINYGLTF_TYPE_SCALAR || (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
                                                  type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
                                                  type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)) {
        throw InputError(where, "indices must be unsigned scalars of 8, 16 or 32 bits",
                         "type " + std::to_string(accessor.type) + ", component type " +
                             std::to_string(type));
    }
    const ElementSpan span = find_elements(document, index);
    const int width = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type));
    std::vector<std::uint32_t> indices(span.count);
    for (std::size_t i = 0; i < span.count; ++i) {
        std::uint32_t value = 0;
        for (int byte = 0; byte < width; ++byte) {
            value |= static_cast<std::uint32_t>(
                         span.data[i * span.stride + static_cast<std::size_t>(byte)])
                     << (8 * byte);
        }
        if (value >= limit) {
            throw InputError(where, "element " + std::to_string(i) + " is an index out of range",
                             std::to_string(value), "less than " + std::to_string(limit));
        }
        indices[i] = value;
    }
    return indices;
}

} // namespace alcove
