#include "scenes/common/skinning.hpp"

#include "core/base/assert.hpp"

#include <array>
#include <cmath>

namespace alcove {
namespace {

/// The upper three rows of an affine matrix, column by column: x axis, y axis, z axis, translation.
using Affine = std::array<double, 12>;

Affine take_affine(const glm::dmat4& matrix) {
    Affine affine{};
    for (std::size_t column = 0; column < 4; ++column) {
        for (std::size_t row = 0; row < 3; ++row) {
            affine[3 * column + row] =
                matrix[static_cast<glm::length_t>(column)][static_cast<glm::length_t>(row)];
        }
    }
    return affine;
}

glm::vec3 move_point(const Affine& m, const glm::vec3& point) {
    const double x = point.x;
    const double y = point.y;
    const double z = point.z;
    return {static_cast<float>(m[0] * x + m[3] * y + m[6] * z + m[9]),
            static_cast<float>(m[1] * x + m[4] * y + m[7] * z + m[10]),
            static_cast<float>(m[2] * x + m[5] * y + m[8] * z + m[11])};
}

/// By the cofactors, which are the inverse transpose times the determinant: its sign is all that is
/// left of it after normalisation.
glm::vec3 move_normal(const Affine& m, const glm::vec3& normal) {
    const double x = normal.x;
    const double y = normal.y;
    const double z = normal.z;
    const std::array<double, 9> c{
        m[4] * m[8] - m[5] * m[7], m[5] * m[6] - m[3] * m[8], m[3] * m[7] - m[4] * m[6],
        m[2] * m[7] - m[1] * m[8], m[0] * m[8] - m[2] * m[6], m[1] * m[6] - m[0] * m[7],
        m[1] * m[5] - m[2] * m[4], m[2] * m[3] - m[0] * m[5], m[0] * m[4] - m[1] * m[3]};
    const double nx = c[0] * x + c[3] * y + c[6] * z;
    const double ny = c[1] * x + c[4] * y + c[7] * z;
    const double nz = c[2] * x + c[5] * y + c[8] * z;
    const double determinant = m[0] * c[0] + m[1] * c[1] + m[2] * c[2];
    const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
    if (!(length > 0.0) || !std::isfinite(length)) {
        return normal;
    }
    const double scale = (determinant < 0.0 ? -1.0 : 1.0) / length;
    return {static_cast<float>(nx * scale), static_cast<float>(ny * scale),
            static_cast<float>(nz * scale)};
}

} // namespace

Deformation skin_vertices(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                          const SkinInfluences& influences,
                          std::span<const glm::dmat4> joint_matrices) {
    const std::size_t per_vertex = influences.per_vertex;
    ALCOVE_ASSERT(normals.size() == positions.size() &&
                      influences.joints.size() == positions.size() * per_vertex &&
                      influences.weights.size() == influences.joints.size(),
                  "a normal and all influences a vertex");
    std::vector<Affine> joints;
    joints.reserve(joint_matrices.size());
    for (const glm::dmat4& matrix : joint_matrices) {
        joints.push_back(take_affine(matrix));
    }
    Deformation result{std::vector<glm::vec3>(positions.size()),
                       std::vector<glm::vec3>(positions.size())};
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
        Affine blend{};
        for (std::size_t i = vertex * per_vertex; i < (vertex + 1) * per_vertex; ++i) {
            const double weight = influences.weights[i];
            if (weight == 0.0) {
                continue;
            }
            ALCOVE_ASSERT(influences.joints[i] < joints.size(), "a joint of the skin");
            const Affine& joint = joints[influences.joints[i]];
            for (std::size_t k = 0; k < blend.size(); ++k) {
                blend[k] += weight * joint[k];
            }
        }
        result.positions[vertex] = move_point(blend, positions[vertex]);
        result.normals[vertex] = move_normal(blend, normals[vertex]);
    }
    return result;
}

bool normalise_weights(SkinInfluences& influences) {
    ALCOVE_ASSERT(influences.per_vertex > 0, "room for an influence");
    const std::size_t per_vertex = influences.per_vertex;
    std::vector<double> sums(influences.weights.size() / per_vertex, 0.0);
    for (std::size_t i = 0; i < influences.weights.size(); ++i) {
        const double weight = influences.weights[i];
        if (!(weight >= 0.0) || !std::isfinite(weight)) {
            return false;
        }
        sums[i / per_vertex] += weight;
    }
    for (const double sum : sums) {
        if (!(sum > 0.0)) {
            return false;
        }
    }
    for (std::size_t i = 0; i < influences.weights.size(); ++i) {
        influences.weights[i] =
            static_cast<float>(static_cast<double>(influences.weights[i]) / sums[i / per_vertex]);
    }
    return true;
}

} // namespace alcove
