#include "scenes/common/morphing.hpp"

#include "core/base/assert.hpp"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

void add_deltas(const MorphDeltas& deltas, double weight, std::vector<glm::vec3>& sums) {
    for (std::size_t i = 0; i < deltas.vertices.size(); ++i) {
        ALCOVE_ASSERT(deltas.vertices[i] < sums.size(), "a vertex of the mesh");
        sums[deltas.vertices[i]] += static_cast<float>(weight) * deltas.deltas[i];
    }
}

} // namespace

MorphDeltas collect_deltas(std::span<const glm::vec3> deltas) {
    ALCOVE_ASSERT(deltas.size() <= std::numeric_limits<std::uint32_t>::max(), "32 bit indices");
    MorphDeltas collected;
    for (std::size_t i = 0; i < deltas.size(); ++i) {
        if (deltas[i] != glm::vec3(0.0f)) {
            collected.vertices.push_back(static_cast<std::uint32_t>(i));
            collected.deltas.push_back(deltas[i]);
        }
    }
    return collected;
}

Deformation morph_vertices(const Mesh& mesh, std::span<const MorphTarget> targets,
                           std::span<const double> weights) {
    ALCOVE_ASSERT(targets.size() == weights.size(), "one weight a target");
    Deformation result{mesh.positions, mesh.normals};
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (weights[i] != 0.0) {
            add_deltas(targets[i].positions, weights[i], result.positions);
            add_deltas(targets[i].normals, weights[i], result.normals);
        }
    }
    for (std::size_t i = 0; i < result.normals.size(); ++i) {
        const float length = glm::length(result.normals[i]);
        const bool has_direction = length > 1e-6f && std::isfinite(length);
        result.normals[i] = has_direction ? result.normals[i] / length : mesh.normals[i];
    }
    return result;
}

void make_flat_normals(std::span<const std::uint32_t> indices, bool turned,
                       Deformation& deformation) {
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const glm::dvec3 a(deformation.positions[indices[i]]);
        const glm::dvec3 b(deformation.positions[indices[i + 1]]);
        const glm::dvec3 c(deformation.positions[indices[i + 2]]);
        const glm::dvec3 cross = glm::cross(b - a, c - a);
        const double length = glm::length(cross);
        if (length > 0.0 && std::isfinite(length)) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                deformation.normals[indices[i + corner]] =
                    glm::vec3((turned ? -cross : cross) / length);
            }
        }
    }
}

} // namespace alcove
