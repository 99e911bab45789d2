#pragma once
// Morph targets: displacements of a mesh's vertices that are added by weights (glTF 2.0, 3.7.2.2).

#include "core/contract/scene.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace alcove {

/// Displacements of the vertices that have one: faces move a few of many.
struct MorphDeltas {
    std::vector<std::uint32_t> vertices;
    std::vector<glm::vec3> deltas; ///< beside them
};

struct MorphTarget {
    MorphDeltas positions;
    MorphDeltas normals;
};

/// Leaves the zeros out. Asserts at most 2^32 vertices.
[[nodiscard]] MorphDeltas collect_deltas(std::span<const glm::vec3> deltas);

/// Positions and normals of the mesh plus the weighted displacements, summed in float in the order
/// of the targets; normals are made unit again, or stay the mesh's where they vanish. Asserts one
/// weight a target and vertices in range.
[[nodiscard]] Deformation morph_vertices(const Mesh& mesh, std::span<const MorphTarget> targets,
                                         std::span<const double> weights);

/// Gives all three corners of each triangle the normal of its plane, for meshes whose triangles
/// share no vertices; one without area keeps its normals. `turned`: triangles are clockwise seen
/// from outside, since their object is mirrored.
void make_flat_normals(std::span<const std::uint32_t> indices, bool turned,
                       Deformation& deformation);

} // namespace alcove
