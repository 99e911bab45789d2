#pragma once
// Nodes that hang on each other and move by keys: the skeleton of an animated scene.

#include "scenes/common/keyframes.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

namespace alcove {

/// Scaled, then turned, then moved, relative to its parent.
struct TreeNode {
    std::optional<std::size_t> parent; ///< a node before this one
    glm::dvec3 translation{0.0};       ///< metres
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
    std::optional<glm::dmat4> matrix; ///< affine, in place of all others
    std::optional<Keyframes> moving_translation;
    std::optional<Keyframes> moving_rotation;
    std::optional<Keyframes> moving_scale; ///< a factor of 0 becomes 1e-6: normals need an inverse

    [[nodiscard]] bool is_keyed() const {
        return moving_translation || moving_rotation || moving_scale;
    }
};

/// The time of a clip that repeats every `duration_s` seconds, in [0, duration); 0 if that is not
/// positive.
[[nodiscard]] double wrap_time(double time_s, double duration_s);

/// Where every node is: to the space the roots stand in. In double, from the time alone. Asserts
/// that parents come first.
[[nodiscard]] std::vector<glm::dmat4> compute_nodes(const std::vector<TreeNode>& nodes,
                                                    double time_s);

/// True for every node that moves with its own keys or with an ancestor's.
[[nodiscard]] std::vector<bool> find_moving(const std::vector<TreeNode>& nodes);

} // namespace alcove
