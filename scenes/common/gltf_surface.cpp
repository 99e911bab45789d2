#include "scenes/common/gltf_surface.hpp"

#include "core/base/error.hpp"
#include "scenes/common/gltf_accessor.hpp"
#include "scenes/common/gltf_material.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <tiny_gltf.h>

namespace alcove {
namespace {

void check_count(std::size_t count, const Mesh& mesh, const std::string& where) {
    if (count != mesh.positions.size()) {
        throw InputError(where, "number of elements differs from POSITION's", std::to_string(count),
                         std::to_string(mesh.positions.size()));
    }
}

void read_colors(const GltfDocument& document, int accessor, GltfWarnings& warnings, Mesh& mesh) {
    const std::string where = document.name("accessors", accessor);
    const std::size_t components = count_components(document, accessor);
    if (components != 3 && components != 4) {
        throw InputError(where, "colours have another type", {}, "VEC3 or VEC4");
    }
    const auto numbers = read_numbers(document, accessor, components, GltfNumbers::normalised);
    check_count(numbers.size() / components, mesh, where);
    document.charge(mesh.positions.size() * sizeof(glm::vec3), where);
    for (std::size_t i = 0; i < numbers.size(); i += components) {
        const glm::vec3 color(numbers[i], numbers[i + 1], numbers[i + 2]);
        const glm::vec3 clamped = glm::clamp(color, glm::vec3(0.0f), glm::vec3(1.0f));
        if (clamped != color) {
            warnings.insert("colours beyond [0,1] are clamped: " + where);
        }
        mesh.colors.push_back(clamped);
    }
}

void read_coordinates(const GltfDocument& document, int accessor, const GltfMaterial& material,
                      GltfWarnings& warnings, Mesh& mesh) {
    const auto pairs = read_pairs(document, accessor, GltfNumbers::quantised_uv);
    check_count(pairs.size(), mesh, document.name("accessors", accessor));
    bool leaves = false;
    for (const glm::vec2& pair : pairs) {
        const glm::vec2 place(material.transform * glm::dvec3(pair, 1.0));
        if (!std::isfinite(place.x) || !std::isfinite(place.y)) {
            throw InputError(document.name("accessors", accessor),
                             "texture coordinates are transformed beyond all numbers");
        }
        leaves = leaves || place.x < 0.0f || place.x > 1.0f || place.y < 0.0f || place.y > 1.0f;
        mesh.texture_coordinates.push_back(place);
    }
    if (leaves && !material.repeats) {
        warnings.insert("textures repeat, clamping and mirroring are ignored: mesh " + mesh.name);
    }
}

} // namespace

void read_surface(const GltfDocument& document, const tinygltf::Primitive& primitive,
                  const std::string& where, GltfTextures& textures, GltfWarnings& warnings,
                  Mesh& mesh) {
    const GltfMaterial material =
        read_material(document, primitive.material, where, textures, warnings);
    mesh.albedo = material.albedo;
    const auto colors = primitive.attributes.find("COLOR_0");
    if (colors != primitive.attributes.end()) {
        read_colors(document, colors->second, warnings, mesh);
    }
    if (!material.texture) {
        return;
    }
    const std::string set = "TEXCOORD_" + std::to_string(material.coordinate_set);
    const auto coordinates = primitive.attributes.find(set);
    if (coordinates == primitive.attributes.end()) {
        warnings.insert("texture is ignored, " + where + " has no " + set);
        return;
    }
    read_coordinates(document, coordinates->second, material, warnings, mesh);
    mesh.texture = material.texture;
}

} // namespace alcove
