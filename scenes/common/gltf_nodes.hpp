#pragma once
// The node trees of a glTF scene.

#include "scenes/common/gltf_document.hpp"
#include "scenes/common/node_tree.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace alcove {

struct GltfTree {
    std::vector<TreeNode> nodes;                    ///< parents first
    std::vector<int> indices;                       ///< of each node, in the file
    std::vector<std::optional<std::size_t>> places; ///< of each node of the file, in `nodes`

    /// "file: nodes[i]" of a node here.
    [[nodiscard]] std::string name(const GltfDocument& document, std::size_t node) const;
};

/// The nodes of the default scene at rest; without a scene, and with a warning, all. Throws
/// InputError on nodes that are reached twice or lie deeper than 256, and on transforms that are
/// not affine or not finite.
[[nodiscard]] GltfTree read_nodes(const GltfDocument& document, GltfWarnings& warnings);

} // namespace alcove
