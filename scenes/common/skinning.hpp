#pragma once
// Linear blend skinning: the vertices of a mesh that joints pull along.
//
// This work is based on: N. Magnenat-Thalmann, R. Laperrière, D. Thalmann. Joint-dependent local
// deformations for hand animation and object grasping. 1988; as glTF 2.0, 3.7.3.3, uses it.

#include "core/contract/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// Which joints pull each vertex and how much. Usually four a vertex; unused ones weigh 0.
struct SkinInfluences {
    std::size_t per_vertex = 4;
    std::vector<std::uint16_t> joints; ///< per_vertex a vertex
    std::vector<float> weights;        ///< beside them, not negative; those of a vertex sum to 1
};

/// Moves every vertex by the weighted mean M of its joints' matrices, and its normal by the inverse
/// transpose of M. `joint_matrices` take the mesh at rest to where the joint puts it, i.e.
/// joint_to_object * inverse_bind; double, so that a joint may be far from 0. A normal that M
/// flattens to nothing stays as it was. Arithmetic is double throughout, results are rounded once.
/// Asserts that sizes agree and joints are in range.
[[nodiscard]] Deformation skin_vertices(std::span<const glm::vec3> positions,
                                        std::span<const glm::vec3> normals,
                                        const SkinInfluences& influences,
                                        std::span<const glm::dmat4> joint_matrices);

/// Divides the weights of each vertex by their sum. Returns false, and changes nothing, if one is
/// negative or not finite or if a vertex has none above 0.
[[nodiscard]] bool normalise_weights(SkinInfluences& influences);

} // namespace alcove
