#include "scenes/common/node_tree.hpp"

#include "core/base/assert.hpp"

#include <cmath>

namespace alcove {
namespace {

constexpr double kSmallestScale = 1e-6;

glm::dmat4 compute_local(const TreeNode& node, double time_s) {
    if (node.matrix) {
        return *node.matrix;
    }
    glm::dmat4 local = glm::mat4_cast(
        node.moving_rotation ? evaluate_rotation(*node.moving_rotation, time_s) : node.rotation);
    glm::dvec3 scale = node.scale;
    if (node.moving_scale) {
        scale = evaluate_vector(*node.moving_scale, time_s);
        for (int i = 0; i < 3; ++i) {
            if (std::abs(scale[i]) < kSmallestScale) {
                scale[i] = std::copysign(kSmallestScale, scale[i]);
            }
        }
    }
    for (int i = 0; i < 3; ++i) {
        local[i] *= scale[i];
    }
    local[3] =
        glm::dvec4(node.moving_translation ? evaluate_vector(*node.moving_translation, time_s)
                                           : node.translation,
                   1.0);
    return local;
}

} // namespace

double wrap_time(double time_s, double duration_s) {
    if (!(duration_s > 0.0)) {
        return 0.0;
    }
    const double rest = std::fmod(time_s, duration_s);
    return rest < 0.0 ? rest + duration_s : rest;
}

std::vector<glm::dmat4> compute_nodes(const std::vector<TreeNode>& nodes, double time_s) {
    std::vector<glm::dmat4> matrices;
    matrices.reserve(nodes.size());
    for (const TreeNode& node : nodes) {
        const glm::dmat4 local = compute_local(node, time_s);
        ALCOVE_ASSERT(!node.parent || *node.parent < matrices.size(), "parents come first");
        matrices.push_back(node.parent ? matrices[*node.parent] * local : local);
    }
    return matrices;
}

std::vector<bool> find_moving(const std::vector<TreeNode>& nodes) {
    std::vector<bool> moving;
    for (const TreeNode& node : nodes) {
        moving.push_back(node.is_keyed() || (node.parent && moving[*node.parent]));
    }
    return moving;
}

} // namespace alcove
