#pragma once
// A closed thin sheet over a grid of points: cloth, a shield. Its triangles stay the same however
// the points move.

#include "core/contract/scene.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace alcove {

/// Both sides and a rim with normals of its own. Point (column, row) of the middle is number
/// row * (columns + 1) + column. The front is where columns cross rows points to.
class ThinSheet {
  public:
    /// Asserts cells and a thickness (metres).
    ThinSheet(int columns, int rows, double thickness_m);

    [[nodiscard]] int columns() const noexcept { return m_columns; }
    [[nodiscard]] int rows() const noexcept { return m_rows; }
    [[nodiscard]] std::vector<std::uint32_t> make_indices() const;
    /// From the points of the middle. Where the rim meets a side both have equal positions.
    [[nodiscard]] Deformation wrap(std::span<const glm::dvec3> middle) const;
    [[nodiscard]] Mesh make_mesh(std::string name, const glm::vec3& albedo,
                                 std::span<const glm::dvec3> middle) const;

  private:
    /// Points around the front, counter-clockwise.
    [[nodiscard]] std::vector<std::size_t> list_rim() const;

    int m_columns;
    int m_rows;
    double m_half_thickness_m;
    std::vector<std::size_t> m_rim;
};

} // namespace alcove
