#include "scenes/common/gltf_morph.hpp"

#include "core/base/error.hpp"
#include "scenes/common/gltf_accessor.hpp"

#include <tiny_gltf.h>

namespace alcove {
namespace {

constexpr std::size_t kMostTargets = 4096;

MorphDeltas read_deltas(const GltfDocument& document, int accessor,
                        std::span<const std::uint32_t> order, std::size_t vertices) {
    const auto deltas = read_vectors(document, accessor, GltfNumbers::quantised);
    const std::string where = document.name("accessors", accessor);
    if (deltas.size() != vertices) {
        throw InputError(where, "number of elements differs from POSITION's",
                         std::to_string(deltas.size()), std::to_string(vertices));
    }
    document.charge(order.size() * sizeof(glm::vec3), where);
    std::vector<glm::vec3> ordered;
    ordered.reserve(order.size());
    for (const std::uint32_t vertex : order) {
        ordered.push_back(deltas[vertex]);
    }
    return collect_deltas(ordered);
}

} // namespace

std::vector<MorphTarget> read_morph_targets(const GltfDocument& document,
                                            const tinygltf::Primitive& primitive,
                                            std::span<const std::uint32_t> order,
                                            std::size_t vertices, const std::string& where) {
    if (primitive.targets.size() > kMostTargets) {
        throw InputError(where + ".targets", "too many morph targets",
                         std::to_string(primitive.targets.size()),
                         "at most " + std::to_string(kMostTargets));
    }
    std::vector<MorphTarget> targets;
    for (const auto& source : primitive.targets) {
        MorphTarget target;
        if (const auto found = source.find("POSITION"); found != source.end()) {
            target.positions = read_deltas(document, found->second, order, vertices);
        }
        if (const auto found = source.find("NORMAL"); found != source.end()) {
            target.normals = read_deltas(document, found->second, order, vertices);
        }
        targets.push_back(std::move(target));
    }
    return targets;
}

} // namespace alcove
