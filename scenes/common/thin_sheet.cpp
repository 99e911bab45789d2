#include "scenes/common/thin_sheet.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {

ThinSheet::ThinSheet(int columns, int rows, double thickness_m)
    : m_columns(columns), m_rows(rows), m_half_thickness_m(0.5 * thickness_m) {
    ALCOVE_ASSERT(columns > 0 && rows > 0 && thickness_m > 0.0, "a sheet has cells and a body");
    m_rim = list_rim();
}

std::vector<std::size_t> ThinSheet::list_rim() const {
    std::vector<std::size_t> rim;
    const auto add = [&](int column, int row) {
        rim.push_back(static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns + 1) +
                      static_cast<std::size_t>(column));
    };
    for (int column = 0; column < m_columns; ++column) {
        add(column, 0);
    }
    for (int row = 0; row < m_rows; ++row) {
        add(m_columns, row);
    }
    for (int column = m_columns; column > 0; --column) {
        add(column, m_rows);
    }
    for (int row = m_rows; row > 0; --row) {
        add(0, row);
    }
    return rim;
}

std::vector<std::uint32_t> ThinSheet::make_indices() const {
    const auto stride = static_cast<std::uint32_t>(m_columns + 1);
    const std::uint32_t points = stride * static_cast<std::uint32_t>(m_rows + 1);
    std::vector<std::uint32_t> indices;
    const auto add_quad = [&indices](std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                     std::uint32_t d) {
        indices.insert(indices.end(), {a, b, c, a, c, d});
    };
    for (std::uint32_t row = 0; row + 1 < points / stride; ++row) {
        for (std::uint32_t column = 0; column + 1 < stride; ++column) {
            const std::uint32_t a = row * stride + column;
            const std::uint32_t c = a + stride + 1;
            add_quad(a, a + 1, c, c - 1);
            add_quad(points + a, points + c - 1, points + c, points + a + 1);
        }
    }
    const auto rim = static_cast<std::uint32_t>(m_rim.size());
    for (std::uint32_t i = 0; i < rim; ++i) { // two vertices a point: front, back
        const std::uint32_t a = 2 * (points + i);
        const std::uint32_t b = 2 * (points + (i + 1) % rim);
        add_quad(a, a + 1, b + 1, b);
    }
    return indices;
}

Deformation ThinSheet::wrap(std::span<const glm::dvec3> middle) const {
    const auto stride = static_cast<std::size_t>(m_columns + 1);
    const std::size_t points = stride * static_cast<std::size_t>(m_rows + 1);
    ALCOVE_ASSERT(middle.size() == points, "a point of the middle for each of the grid");
    Deformation sheet;
    sheet.positions.resize(2 * points + 2 * m_rim.size());
    sheet.normals.resize(sheet.positions.size());
    for (std::size_t row = 0; row < points / stride; ++row) {
        const std::size_t above = row == 0 ? 0 : stride;
        const std::size_t below = (row + 1) * stride == points ? 0 : stride;
        for (std::size_t column = 0; column < stride; ++column) {
            const std::size_t i = row * stride + column;
            const std::size_t left = column == 0 ? i : i - 1;
            const std::size_t right = column + 1 == stride ? i : i + 1;
            const glm::dvec3 normal = glm::normalize(
                glm::cross(middle[right] - middle[left], middle[i + below] - middle[i - above]));
            sheet.positions[i] = middle[i] + m_half_thickness_m * normal;
            sheet.positions[points + i] = middle[i] - m_half_thickness_m * normal;
            sheet.normals[i] = normal;
            sheet.normals[points + i] = -sheet.normals[i];
        }
    }
    for (std::size_t i = 0; i < m_rim.size(); ++i) {
        const std::size_t point = m_rim[i];
        const glm::dvec3 along = middle[m_rim[(i + 1) % m_rim.size()]] -
                                 middle[m_rim[(i + m_rim.size() - 1) % m_rim.size()]];
        const glm::vec3 outward(
            glm::normalize(glm::cross(along, glm::dvec3(sheet.normals[point]))));
        const std::size_t vertex = 2 * (points + i);
        sheet.positions[vertex] = sheet.positions[point];
        sheet.positions[vertex + 1] = sheet.positions[points + point];
        sheet.normals[vertex] = outward;
        sheet.normals[vertex + 1] = outward;
    }
    return sheet;
}

Mesh ThinSheet::make_mesh(std::string name, const glm::vec3& albedo,
                          std::span<const glm::dvec3> middle) const {
    Deformation sheet = wrap(middle);
    Mesh mesh;
    mesh.name = std::move(name);
    mesh.albedo = albedo;
    mesh.positions = std::move(sheet.positions);
    mesh.normals = std::move(sheet.normals);
    mesh.indices = make_indices();
    mesh.closed = true;
    return mesh;
}

} // namespace alcove
