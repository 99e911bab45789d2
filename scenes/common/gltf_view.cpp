#include "scenes/common/gltf_view.hpp"

#include "core/base/error.hpp"

#include <cstdint>

#include <tiny_gltf.h>

namespace alcove {
namespace {

/// Elements of an accessor that no view backs (zeros, but for the sparse part): a few bytes of file
/// may ask for them.
constexpr std::size_t kMostUnbacked = std::size_t{1} << 22;

ElementSpan fit(std::span<const unsigned char> view, std::size_t offset, std::size_t element,
                std::size_t stride, std::size_t count, const std::string& where) {
    // No sum can overflow: each side is bounded by the view's length before it is used.
    if (offset > view.size() || element > view.size() - offset ||
        count - 1 > (view.size() - offset - element) / stride) {
        throw InputError(where, "reaches beyond its buffer view",
                         std::to_string(count) + " elements at byte " + std::to_string(offset),
                         "at most " + std::to_string(view.size()) + " bytes");
    }
    return {view.data() + offset, stride, count};
}

} // namespace

std::span<const unsigned char> find_view(const GltfDocument& document, int index,
                                         const std::string& user) {
    const tinygltf::Model& model = *document.model;
    if (index < 0 || static_cast<std::size_t>(index) >= model.bufferViews.size()) {
        throw InputError(user, "no such buffer view", std::to_string(index),
                         "less than " + std::to_string(model.bufferViews.size()));
    }
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(index)];
    const std::string where = document.name("bufferViews", index);
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) {
        throw InputError(where + ".buffer", "no such buffer", std::to_string(view.buffer),
                         "less than " + std::to_string(model.buffers.size()));
    }
    const std::vector<unsigned char>& data =
        model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) {
        throw InputError(where, "reaches beyond its buffer",
                         std::to_string(view.byteOffset) + " + " + std::to_string(view.byteLength),
                         "at most " + std::to_string(data.size()));
    }
    return {data.data() + view.byteOffset, view.byteLength};
}

const tinygltf::Accessor& find_accessor(const GltfDocument& document, int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= document.model->accessors.size()) {
        throw InputError(document.name("accessors", index), "no such accessor", {},
                         "less than " + std::to_string(document.model->accessors.size()));
    }
    return document.model->accessors[static_cast<std::size_t>(index)];
}

AccessorLayout find_layout(const GltfDocument& document, int index) {
    const tinygltf::Accessor& accessor = find_accessor(document, index);
    const std::string where = document.name("accessors", index);
    const int component =
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    const int components =
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    if (component <= 0 || components <= 0 || accessor.count == 0) {
        throw InputError(where, "type, component type or count is invalid");
    }
    AccessorLayout layout;
    layout.component_type = accessor.componentType;
    layout.component_bytes = static_cast<std::size_t>(component);
    layout.components = static_cast<std::size_t>(components);
    layout.count = accessor.count;
    layout.normalised = accessor.normalized;
    if (accessor.bufferView < 0 && accessor.sparse.isSparse) {
        if (accessor.count > kMostUnbacked) {
            throw InputError(where, "too many elements without a buffer view",
                             std::to_string(accessor.count),
                             "at most " + std::to_string(kMostUnbacked));
        }
        return layout;
    }
    const auto view = find_view(document, accessor.bufferView, where + ".bufferView");
    const std::size_t element = layout.component_bytes * layout.components;
    const std::size_t told =
        document.model->bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
    if (told != 0 && (told < element || told > 252 || told % layout.component_bytes != 0)) {
        throw InputError(document.name("bufferViews", accessor.bufferView) + ".byteStride",
                         "invalid", std::to_string(told),
                         std::to_string(element) + " to 252, a multiple of " +
                             std::to_string(component));
    }
    layout.base =
        fit(view, accessor.byteOffset, element, told != 0 ? told : element, accessor.count, where);
    return layout;
}

ElementSpan find_packed(const GltfDocument& document, int view, int offset, std::size_t bytes,
                        std::size_t count, const std::string& where) {
    if (offset < 0) {
        throw InputError(where + ".byteOffset", "negative", std::to_string(offset));
    }
    return fit(find_view(document, view, where + ".bufferView"), static_cast<std::size_t>(offset),
               bytes, bytes, count, where);
}

} // namespace alcove
