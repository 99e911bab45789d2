#pragma once
// A tree of boxes over objects that stand still: whole branches are left out at one test.

#include "core/frame/view_volume.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace alcove {

class BoxTree {
  public:
    /// Items are told by their index in `boxes`. May be empty.
    explicit BoxTree(std::span<const OrientedBox> boxes);

    /// Calls `found(item)` for every item of the leaves that `keeps(const OrientedBox&)` lets in,
    /// in no promised order. `keeps` sees boxes of branches, not of items.
    template <class Keeps, class Found>
    void visit(const Keeps& keeps, const Found& found) const {
        std::vector<std::uint32_t> pending;
        if (!m_nodes.empty()) {
            pending.push_back(0);
        }
        while (!pending.empty()) {
            const Node& node = m_nodes[pending.back()];
            pending.pop_back();
            if (!keeps(node.box)) {
                continue;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                found(m_items[i]);
            }
            if (node.count == 0) {
                pending.push_back(node.left);
                pending.push_back(node.right);
            }
        }
    }

  private:
    struct Node {
        OrientedBox box; ///< parallel to the axes
        std::uint32_t left = 0;
        std::uint32_t right = 0;
        std::uint32_t first = 0; ///< of a leaf's items
        std::uint32_t count = 0; ///< 0: a branch
    };
    std::uint32_t build(std::span<const OrientedBox> boxes, std::uint32_t first,
                        std::uint32_t last);

    std::vector<std::uint32_t> m_items;
    std::vector<Node> m_nodes;
};

} // namespace alcove
