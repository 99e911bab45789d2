#include "scenes/common/gltf_material.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <tiny_gltf.h>

namespace alcove {
namespace {

constexpr const char* kTextureTransform = "KHR_texture_transform";

void list_ignored(const tinygltf::Material& material, const std::string& where,
                  GltfWarnings& warnings) {
    if (material.alphaMode != "OPAQUE") {
        warnings.insert("transparency is ignored, the surface is opaque: " + where +
                        " (alphaMode " + material.alphaMode.substr(0, 20) + ")");
    }
    const bool has_more = material.pbrMetallicRoughness.metallicRoughnessTexture.index >= 0 ||
                          material.normalTexture.index >= 0 ||
                          material.occlusionTexture.index >= 0 ||
                          material.emissiveTexture.index >= 0;
    if (has_more) {
        warnings.insert("normal, metallic-roughness, occlusion and emissive textures are ignored");
    }
    if (std::any_of(material.emissiveFactor.begin(), material.emissiveFactor.end(),
                    [](double value) { return value != 0.0; })) {
        warnings.insert("emission is ignored: " + where);
    }
}

double read_number(const tinygltf::Value& value, const std::string& where) {
    if (!value.IsNumber() || !std::isfinite(value.GetNumberAsDouble())) {
        throw InputError(where, "is not a number");
    }
    return value.GetNumberAsDouble();
}

glm::dvec2 read_pair(const tinygltf::Value& object, const char* key, const glm::dvec2& otherwise,
                     const std::string& where) {
    if (!object.Has(key)) {
        return otherwise;
    }
    const tinygltf::Value& value = object.Get(key);
    if (!value.IsArray() || value.ArrayLen() != 2) {
        throw InputError(where + "." + key, "is not a pair of numbers");
    }
    return {read_number(value.Get(0), where + "." + key),
            read_number(value.Get(1), where + "." + key)};
}

/// Offset * rotation * scale (KHR_texture_transform). The rotation is counter-clockwise as the text
/// says and viewers do, seen with v pointing down; the sketch in the text turns the other way.
void read_transform(const tinygltf::Value& extension, const std::string& where,
                    GltfMaterial& material) {
    if (!extension.IsObject()) {
        throw InputError(where, "is not an object");
    }
    const glm::dvec2 offset = read_pair(extension, "offset", glm::dvec2(0.0), where);
    const glm::dvec2 scale = read_pair(extension, "scale", glm::dvec2(1.0), where);
    const double angle = extension.Has("rotation")
                             ? read_number(extension.Get("rotation"), where + ".rotation")
                             : 0.0;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    material.transform =
        glm::dmat3x2(glm::dvec2(c, -s) * scale.x, glm::dvec2(s, c) * scale.y, offset);
    if (extension.Has("texCoord")) {
        const double set = read_number(extension.Get("texCoord"), where + ".texCoord");
        if (!(set >= 0.0 && set <= 15.0) || set != std::floor(set)) {
            throw InputError(where + ".texCoord", "out of range", {}, "0 to 15");
        }
        material.coordinate_set = static_cast<int>(set);
    }
}

void read_base_texture(const GltfDocument& document, const tinygltf::TextureInfo& info,
                       const std::string& where, GltfTextures& textures, GltfMaterial& material) {
    material.texture = textures.find(info.index, where);
    if (!material.texture) {
        return;
    }
    if (info.texCoord < 0 || info.texCoord > 15) {
        throw InputError(where + ".texCoord", "out of range", std::to_string(info.texCoord),
                         "0 to 15");
    }
    material.coordinate_set = info.texCoord;
    const auto transform = info.extensions.find(kTextureTransform);
    if (transform != info.extensions.end()) {
        read_transform(transform->second, where + "." + kTextureTransform, material);
    }
    const tinygltf::Model& model = *document.model;
    const int sampler = model.textures[static_cast<std::size_t>(info.index)].sampler;
    if (sampler >= 0) {
        if (static_cast<std::size_t>(sampler) >= model.samplers.size()) {
            throw InputError(document.name("textures", info.index) + ".sampler", "no such sampler",
                             std::to_string(sampler),
                             "less than " + std::to_string(model.samplers.size()));
        }
        const tinygltf::Sampler& source = model.samplers[static_cast<std::size_t>(sampler)];
        material.repeats = source.wrapS == TINYGLTF_TEXTURE_WRAP_REPEAT &&
                           source.wrapT == TINYGLTF_TEXTURE_WRAP_REPEAT;
    }
}

} // namespace

GltfMaterial read_material(const GltfDocument& document, int index, const std::string& user,
                           GltfTextures& textures, GltfWarnings& warnings) {
    GltfMaterial result;
    if (index < 0) {
        return result;
    }
    if (static_cast<std::size_t>(index) >= document.model->materials.size()) {
        throw InputError(user + ".material", "no such material", std::to_string(index),
                         "less than " + std::to_string(document.model->materials.size()));
    }
    const tinygltf::Material& material = document.model->materials[static_cast<std::size_t>(index)];
    const std::string where = document.name("materials", index);
    const std::vector<double>& factor = material.pbrMetallicRoughness.baseColorFactor;
    const bool in_range = factor.size() == 4 &&
                          std::all_of(factor.begin(), factor.end(),
                                      [](double value) { return value >= 0.0 && value <= 1.0; });
    if (!in_range) {
        throw InputError(where + ".baseColorFactor", "out of range", {},
                         "four numbers from 0 to 1");
    }
    result.albedo = glm::vec3(glm::dvec3(factor[0], factor[1], factor[2]));
    list_ignored(material, where, warnings);
    const tinygltf::TextureInfo& base = material.pbrMetallicRoughness.baseColorTexture;
    if (base.index >= 0) {
        read_base_texture(document, base, where + ".baseColorTexture", textures, result);
    }
    return result;
}

} // namespace alcove
