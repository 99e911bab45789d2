#include "scenes/common/gltf_skin.hpp"

#include "core/base/error.hpp"
#include "scenes/common/gltf_accessor.hpp"

#include <limits>
#include <utility>
#include <vector>

#include <tiny_gltf.h>

namespace alcove {
namespace {

int find_attribute(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

void check_count(std::size_t count, std::size_t vertices, const std::string& where) {
    if (count != 4 * vertices) {
        throw InputError(where, "number of elements differs from POSITION's",
                         std::to_string(count / 4), std::to_string(vertices));
    }
}

/// The last row of an inverse bind matrix is (0, 0, 0, 1).
glm::dmat4 take_affine(std::span<const float> values, const std::string& where) {
    glm::dmat4 matrix(1.0);
    for (std::size_t i = 0; i < 16; ++i) {
        matrix[static_cast<glm::length_t>(i / 4)][static_cast<glm::length_t>(i % 4)] = values[i];
    }
    const glm::dvec4 last(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]);
    if (last != glm::dvec4(0.0, 0.0, 0.0, 1.0)) {
        throw InputError(where, "is not affine", {}, "a last row of 0, 0, 0, 1");
    }
    return matrix;
}

} // namespace

std::optional<SkinInfluences> read_influences(const GltfDocument& document,
                                              const tinygltf::Primitive& primitive,
                                              std::size_t vertices, const std::string& where,
                                              GltfWarnings& warnings) {
    std::vector<std::pair<int, int>> sets; // accessors of joints and weights
    for (int set = 0;; ++set) {
        const std::string number = std::to_string(set);
        const int joints = find_attribute(primitive, "JOINTS_" + number);
        const int weights = find_attribute(primitive, "WEIGHTS_" + number);
        if (joints < 0 && weights < 0) {
            break;
        }
        if (joints < 0 || weights < 0) {
            throw InputError(where, "JOINTS_" + number + " and WEIGHTS_" + number +
                                        " do not stand together");
        }
        sets.emplace_back(joints, weights);
    }
    if (sets.empty()) {
        return std::nullopt;
    }
    SkinInfluences influences;
    influences.per_vertex = 4 * sets.size();
    document.charge(vertices * influences.per_vertex * 6, where);
    influences.joints.resize(vertices * influences.per_vertex);
    influences.weights.resize(vertices * influences.per_vertex);
    for (std::size_t set = 0; set < sets.size(); ++set) {
        const auto joints = read_indices(document, sets[set].first, 4, std::size_t{1} << 16);
        const auto weights = read_numbers(document, sets[set].second, 4, GltfNumbers::normalised);
        check_count(joints.size(), vertices, document.name("accessors", sets[set].first));
        check_count(weights.size(), vertices, document.name("accessors", sets[set].second));
        for (std::size_t i = 0; i < 4 * vertices; ++i) {
            const std::size_t place = i / 4 * influences.per_vertex + 4 * set + i % 4;
            influences.weights[place] = weights[i];
            // What weighs nothing may name any joint.
            influences.joints[place] =
                weights[i] == 0.0f ? std::uint16_t{0} : static_cast<std::uint16_t>(joints[i]);
        }
    }
    if (!normalise_weights(influences)) {
        warnings.insert("skin is ignored, a vertex has no or negative weights: " + where);
        return std::nullopt;
    }
    return influences;
}

std::optional<Skin> read_skin(const GltfDocument& document, int index,
                              std::span<const std::optional<std::size_t>> places,
                              GltfWarnings& warnings) {
    const std::string where = document.name("skins", index);
    if (index < 0 || static_cast<std::size_t>(index) >= document.model->skins.size()) {
        throw InputError(where, "no such skin", {},
                         "less than " + std::to_string(document.model->skins.size()));
    }
    const tinygltf::Skin& source = document.model->skins[static_cast<std::size_t>(index)];
    if (source.joints.empty() || source.joints.size() > std::numeric_limits<std::uint16_t>::max()) {
        throw InputError(where + ".joints", "wrong number of joints",
                         std::to_string(source.joints.size()), "1 to 65535");
    }
    Skin skin;
    for (std::size_t i = 0; i < source.joints.size(); ++i) {
        const int node = source.joints[i];
        if (node < 0 || static_cast<std::size_t>(node) >= places.size()) {
            throw InputError(where + ".joints[" + std::to_string(i) + "]", "no such node",
                             std::to_string(node), "less than " + std::to_string(places.size()));
        }
        const auto place = places[static_cast<std::size_t>(node)];
        if (!place) {
            warnings.insert("skin is ignored, a joint is not in the scene: " + where + ".joints[" +
                            std::to_string(i) + "]");
            return std::nullopt;
        }
        skin.joints.push_back(*place);
    }
    skin.inverse_bind.assign(skin.joints.size(), glm::dmat4(1.0));
    if (source.inverseBindMatrices >= 0) {
        const std::string matrices = document.name("accessors", source.inverseBindMatrices);
        const auto values =
            read_numbers(document, source.inverseBindMatrices, 16, GltfNumbers::real);
        if (values.size() < 16 * skin.joints.size()) {
            throw InputError(matrices, "has fewer inverse bind matrices than the skin has joints",
                             std::to_string(values.size() / 16),
                             std::to_string(skin.joints.size()));
        }
        for (std::size_t i = 0; i < skin.joints.size(); ++i) {
            skin.inverse_bind[i] = take_affine(std::span(values).subspan(16 * i, 16),
                                               matrices + " element " + std::to_string(i));
        }
    }
    return skin;
}

void check_influences(const SkinInfluences& influences, const Skin& skin,
                      const std::string& where) {
    for (std::size_t i = 0; i < influences.joints.size(); ++i) {
        if (influences.joints[i] >= skin.joints.size()) {
            throw InputError(where,
                             "vertex " + std::to_string(i / influences.per_vertex) +
                                 " follows a joint that its skin lacks",
                             std::to_string(influences.joints[i]),
                             "less than " + std::to_string(skin.joints.size()));
        }
    }
}

} // namespace alcove
