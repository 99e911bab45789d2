#include "scenes/common/gltf_accessor.hpp"

#include "core/base/error.hpp"
#include "scenes/common/gltf_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include <tiny_gltf.h>

namespace alcove {
namespace {

std::uint32_t read_unsigned(const unsigned char* data, std::size_t bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
        value |= static_cast<std::uint32_t>(data[i]) << (8 * i);
    }
    return value;
}

/// An integer of 8 or 16 bits as its value, or as what it stands for if normalised.
float decode_integer(const unsigned char* data, const AccessorLayout& layout) {
    const std::uint32_t code = read_unsigned(data, layout.component_bytes);
    const bool is_signed = layout.component_type == TINYGLTF_COMPONENT_TYPE_BYTE ||
                           layout.component_type == TINYGLTF_COMPONENT_TYPE_SHORT;
    const double range = std::exp2(8.0 * static_cast<double>(layout.component_bytes));
    double value = code;
    if (is_signed && value >= 0.5 * range) {
        value -= range;
    }
    if (!layout.normalised) {
        return static_cast<float>(value);
    }
    return static_cast<float>(is_signed ? std::max(value / (0.5 * range - 1.0), -1.0)
                                        : value / (range - 1.0));
}

float decode(const unsigned char* data, const AccessorLayout& layout) {
    if (layout.component_type == TINYGLTF_COMPONENT_TYPE_FLOAT) {
        float value = 0.0f;
        std::memcpy(&value, data, sizeof(value));
        return value;
    }
    return decode_integer(data, layout);
}

void check_numbers(const GltfDocument& document, const AccessorLayout& layout, GltfNumbers numbers,
                   const std::string& where) {
    const int type = layout.component_type;
    if (type == TINYGLTF_COMPONENT_TYPE_FLOAT && !layout.normalised) {
        return;
    }
    const bool is_short =
        type >= TINYGLTF_COMPONENT_TYPE_BYTE && type <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    const bool takes_normalised = numbers == GltfNumbers::normalised ||
                                  numbers == GltfNumbers::quantised_uv || document.is_quantised;
    const bool takes_plain =
        (numbers == GltfNumbers::quantised || numbers == GltfNumbers::quantised_uv) &&
        document.is_quantised;
    const bool fits = numbers != GltfNumbers::real && is_short &&
                      (layout.normalised ? takes_normalised : takes_plain);
    if (!fits) {
        throw InputError(where, "component type is not allowed here",
                         std::to_string(type) + (layout.normalised ? ", normalised" : ""),
                         numbers == GltfNumbers::real
                             ? "float"
                             : "float, or integers as the format and KHR_mesh_quantization allow");
    }
}

void check_shape(const AccessorLayout& layout, std::size_t components, const std::string& where) {
    if (layout.components != components) {
        throw InputError(where, "has another type",
                         std::to_string(layout.components) + " numbers an element",
                         std::to_string(components));
    }
}

/// Where the sparse part puts its values: calls `put(element, data of its values)`.
template <class Put>
void visit_sparse(const GltfDocument& document, int index, const AccessorLayout& layout,
                  const Put& put) {
    const auto& sparse = find_accessor(document, index).sparse;
    if (!sparse.isSparse) {
        return;
    }
    const std::string where = document.name("accessors", index) + ".sparse";
    const int type = sparse.indices.componentType;
    const std::size_t width = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 1
                              : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 2
                              : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT   ? 4
                                                                               : 0;
    if (width == 0 || sparse.count < 1 || static_cast<std::size_t>(sparse.count) > layout.count) {
        throw InputError(where, "count or component type of the indices is invalid",
                         std::to_string(sparse.count), "1 to " + std::to_string(layout.count));
    }
    const auto count = static_cast<std::size_t>(sparse.count);
    const ElementSpan indices =
        find_packed(document, sparse.indices.bufferView, sparse.indices.byteOffset, width, count,
                    where + ".indices");
    const ElementSpan values =
        find_packed(document, sparse.values.bufferView, sparse.values.byteOffset,
                    layout.component_bytes * layout.components, count, where + ".values");
    std::size_t next = 0; // the smallest index that ascends
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t element = read_unsigned(indices.data + i * width, width);
        if (element < next || element >= layout.count) {
            throw InputError(where + ".indices",
                             "element " + std::to_string(i) + " does not ascend or lies outside",
                             std::to_string(element),
                             std::to_string(next) + " to " + std::to_string(layout.count - 1));
        }
        next = element + 1;
        put(element, values.data + i * values.stride);
    }
}

template <class Vector, int components>
std::vector<Vector> read_as(const GltfDocument& document, int accessor, GltfNumbers numbers) {
    const std::vector<float> values = read_numbers(document, accessor, components, numbers);
    std::vector<Vector> vectors(values.size() / components);
    std::memcpy(vectors.data(), values.data(), values.size() * sizeof(float));
    return vectors;
}

} // namespace

std::size_t count_elements(const GltfDocument& document, int accessor) {
    return find_layout(document, accessor).count;
}

std::size_t count_components(const GltfDocument& document, int accessor) {
    return find_layout(document, accessor).components;
}

std::vector<float> read_numbers(const GltfDocument& document, int index, std::size_t components,
                                GltfNumbers numbers) {
    const std::string where = document.name("accessors", index);
    const AccessorLayout layout = find_layout(document, index);
    check_shape(layout, components, where);
    check_numbers(document, layout, numbers, where);
    document.charge(layout.count * components * sizeof(float), where);
    std::vector<float> values(layout.count * components, 0.0f);
    const auto put = [&](std::size_t element, const unsigned char* data) {
        for (std::size_t k = 0; k < components; ++k) {
            const float value = decode(data + k * layout.component_bytes, layout);
            if (!std::isfinite(value)) {
                throw InputError(where, "element " + std::to_string(element) + " is not finite");
            }
            values[element * components + k] = value;
        }
    };
    for (std::size_t i = 0; i < layout.base.count; ++i) {
        put(i, layout.base.data + i * layout.base.stride);
    }
    visit_sparse(document, index, layout, put);
    return values;
}

std::vector<glm::vec2> read_pairs(const GltfDocument& document, int accessor, GltfNumbers numbers) {
    return read_as<glm::vec2, 2>(document, accessor, numbers);
}

std::vector<glm::vec3> read_vectors(const GltfDocument& document, int accessor,
                                    GltfNumbers numbers) {
    return read_as<glm::vec3, 3>(document, accessor, numbers);
}

std::vector<std::uint32_t> read_indices(const GltfDocument& document, int index,
                                        std::size_t components, std::size_t limit) {
    const std::string where = document.name("accessors", index);
    const AccessorLayout layout = find_layout(document, index);
    check_shape(layout, components, where);
    const int type = layout.component_type;
    const bool fits = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                      type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                      (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT && components == 1);
    if (!fits || layout.normalised) {
        throw InputError(where, "indices must be plain unsigned integers",
                         "component type " + std::to_string(type));
    }
    document.charge(layout.count * components * sizeof(std::uint32_t), where);
    std::vector<std::uint32_t> indices(layout.count * components, 0);
    const auto put = [&](std::size_t element, const unsigned char* data) {
        for (std::size_t k = 0; k < components; ++k) {
            indices[element * components + k] =
                read_unsigned(data + k * layout.component_bytes, layout.component_bytes);
        }
    };
    for (std::size_t i = 0; i < layout.base.count; ++i) {
        put(i, layout.base.data + i * layout.base.stride);
    }
    visit_sparse(document, index, layout, put);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] >= limit) {
            throw InputError(
                where, "element " + std::to_string(i / components) + " is an index out of range",
                std::to_string(indices[i]), "less than " + std::to_string(limit));
        }
    }
    return indices;
}

} // namespace alcove
