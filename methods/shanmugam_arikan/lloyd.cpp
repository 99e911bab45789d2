#include "methods/shanmugam_arikan/lloyd.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// Centres sorted into cells of a grid, so that the nearest one is among a few.
class CenterGrid {
  public:
    explicit CenterGrid(std::span<const glm::vec3> centers) : m_centers(centers) {
        glm::vec3 high(-std::numeric_limits<float>::max());
        m_low = -high;
        for (const glm::vec3& center : centers) {
            m_low = glm::min(m_low, center);
            high = glm::max(high, center);
        }
        // About two centres a cell if they fill the box; on surfaces more, in fewer cells.
        const glm::vec3 extent = glm::max(high - m_low, glm::vec3(1e-6f));
        const auto cells = static_cast<float>(std::max<std::size_t>(1, centers.size() / 2));
        m_cell = std::max({std::cbrt(extent.x * extent.y * extent.z / cells),
                           std::max({extent.x, extent.y, extent.z}) / kMostCells, 1e-9f});
        m_size = glm::ivec3(extent / m_cell) + 1;
        m_firsts.assign(static_cast<std::size_t>(m_size.x) * static_cast<std::size_t>(m_size.y) *
                                static_cast<std::size_t>(m_size.z) +
                            1,
                        0);
        for (const glm::vec3& center : centers) {
            ++m_firsts[get_index(find_cell(center)) + 1];
        }
        for (std::size_t i = 1; i < m_firsts.size(); ++i) {
            m_firsts[i] += m_firsts[i - 1];
        }
        m_sorted.resize(centers.size());
        std::vector<std::uint32_t> next(m_firsts.begin(), m_firsts.end() - 1);
        for (std::size_t i = 0; i < centers.size(); ++i) {
            m_sorted[next[get_index(find_cell(centers[i]))]++] = static_cast<std::uint32_t>(i);
        }
    }

    [[nodiscard]] std::uint32_t find_nearest(const glm::vec3& point) const {
        const glm::ivec3 middle = find_cell(point);
        const int most = std::max({m_size.x, m_size.y, m_size.z});
        float best = std::numeric_limits<float>::max();
        std::uint32_t nearest = 0;
        for (int ring = 0; ring <= most; ++ring) {
            // Whatever lies beyond this ring is at least `ring - 1` whole cells away.
            const float beyond = static_cast<float>(ring - 1) * m_cell;
            if (ring > 1 && best < beyond * beyond) {
                break;
            }
            search_ring(middle, ring, point, best, nearest);
        }
        return nearest;
    }

  private:
    static constexpr float kMostCells = 64.0f;

    [[nodiscard]] glm::ivec3 find_cell(const glm::vec3& point) const {
        return glm::clamp(glm::ivec3(glm::floor((point - m_low) / m_cell)), glm::ivec3(0),
                          m_size - 1);
    }
    [[nodiscard]] std::size_t get_index(const glm::ivec3& cell) const {
        return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(m_size.y) +
                static_cast<std::size_t>(cell.y)) *
                   static_cast<std::size_t>(m_size.x) +
               static_cast<std::size_t>(cell.x);
    }
    void search_ring(const glm::ivec3& middle, int ring, const glm::vec3& point, float& best,
                     std::uint32_t& nearest) const {
        const glm::ivec3 low = glm::max(middle - ring, glm::ivec3(0));
        const glm::ivec3 high = glm::min(middle + ring, m_size - 1);
        for (int z = low.z; z <= high.z; ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                for (int x = low.x; x <= high.x; ++x) {
                    const glm::ivec3 off = glm::abs(glm::ivec3(x, y, z) - middle);
                    if (std::max({off.x, off.y, off.z}) == ring) {
                        search_cell(get_index({x, y, z}), point, best, nearest);
                    }
                }
            }
        }
    }
    void search_cell(std::size_t cell, const glm::vec3& point, float& best,
                     std::uint32_t& nearest) const {
        for (std::uint32_t i = m_firsts[cell]; i < m_firsts[cell + 1]; ++i) {
            const std::uint32_t center = m_sorted[i];
            const glm::vec3 off = m_centers[center] - point;
            const float squared = glm::dot(off, off);
            if (squared < best || (squared == best && center < nearest)) {
                best = squared;
                nearest = center;
            }
        }
    }

    std::span<const glm::vec3> m_centers;
    glm::vec3 m_low;
    float m_cell = 1.0f;
    glm::ivec3 m_size{1};
    std::vector<std::uint32_t> m_firsts; ///< of each cell, and the end
    std::vector<std::uint32_t> m_sorted;
};

void move_to_means(std::span<const glm::vec3> points, std::span<const std::uint32_t> owners,
                   std::span<glm::vec3> centers) {
    std::vector<glm::dvec3> sums(centers.size(), glm::dvec3(0.0));
    std::vector<int> counts(centers.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        sums[owners[i]] += glm::dvec3(points[i]);
        ++counts[owners[i]];
    }
    for (std::size_t i = 0; i < centers.size(); ++i) {
        if (counts[i] > 0) {
            centers[i] = glm::vec3(sums[i] / static_cast<double>(counts[i]));
        }
    }
}

} // namespace

std::vector<std::uint32_t> cluster_points(std::span<const glm::vec3> points, std::size_t count,
                                          int iterations) {
    ALCOVE_ASSERT(count >= 1 && count <= points.size(), "a centre, and no more than points");
    std::vector<glm::vec3> centers;
    for (std::size_t i = 0; i < count; ++i) {
        centers.push_back(points[(2 * i + 1) * points.size() / (2 * count)]);
    }
    std::vector<std::uint32_t> owners(points.size(), 0);
    for (int round = 0; round < iterations; ++round) {
        const CenterGrid grid(centers);
        for (std::size_t i = 0; i < points.size(); ++i) {
            owners[i] = grid.find_nearest(points[i]);
        }
        move_to_means(points, owners, centers);
    }
    return owners;
}

} // namespace alcove
