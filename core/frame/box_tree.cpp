#include "core/frame/box_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include <glm/common.hpp>

namespace alcove {
namespace {

constexpr std::uint32_t kLeafItems = 8;

} // namespace

BoxTree::BoxTree(std::span<const OrientedBox> boxes) : m_items(boxes.size()) {
    std::iota(m_items.begin(), m_items.end(), 0u);
    if (!boxes.empty()) {
        build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
    }
}

std::uint32_t BoxTree::build(std::span<const OrientedBox> boxes, std::uint32_t first,
                             std::uint32_t last) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-std::numeric_limits<double>::infinity());
    glm::dvec3 centre_low = low;
    glm::dvec3 centre_high = high;
    for (std::uint32_t i = first; i < last; ++i) {
        const OrientedBox& box = boxes[m_items[i]];
        const glm::dvec3 reach =
            glm::abs(box.half[0]) + glm::abs(box.half[1]) + glm::abs(box.half[2]);
        low = glm::min(low, box.centre - reach);
        high = glm::max(high, box.centre + reach);
        centre_low = glm::min(centre_low, box.centre);
        centre_high = glm::max(centre_high, box.centre);
    }
    const auto index = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes.emplace_back();
    m_nodes[index].box.centre = 0.5 * (low + high);
    for (int i = 0; i < 3; ++i) {
        m_nodes[index].box.half[i][i] = 0.5 * (high[i] - low[i]);
    }
    if (last - first <= kLeafItems) {
        m_nodes[index].first = first;
        m_nodes[index].count = last - first;
        return index;
    }
    const glm::dvec3 spread = centre_high - centre_low;
    const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0
                     : spread.y >= spread.z                       ? 1
                                                                  : 2;
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(m_items.begin() + first, m_items.begin() + middle, m_items.begin() + last,
                     [&boxes, axis](std::uint32_t a, std::uint32_t b) {
                         const double x = boxes[a].centre[axis];
                         const double y = boxes[b].centre[axis];
                         return x < y || (x == y && a < b);
                     });
    const std::uint32_t left = build(boxes, first, middle);
    const std::uint32_t right = build(boxes, middle, last);
    m_nodes[index].left = left;
    m_nodes[index].right = right;
    return index;
}

} // namespace alcove
