#include "scenes/common/solids.hpp"

#include "core/base/assert.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// Closes a plane ring with triangles that face the side it is counter-clockwise from.
void add_cap(MeshBuilder& builder, const Ring& ring, const std::vector<std::uint32_t>& indices,
             bool reversed) {
    glm::dvec3 normal(0.0); // Newell's: robust for concave rings
    for (std::size_t i = 0; i < ring.size(); ++i) {
        normal += glm::cross(ring[i], ring[(i + 1) % ring.size()]);
    }
    const double length = glm::length(normal);
    if (!(length > 1e-12)) {
        return; // a pole
    }
    normal /= length;
    const glm::dvec3 helper =
        std::abs(normal.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 x = glm::normalize(glm::cross(helper, normal));
    const glm::dvec3 y = glm::cross(normal, x);
    Contour contour;
    for (const glm::dvec3& point : ring) {
        contour.emplace_back(glm::dot(point - ring[0], x), glm::dot(point - ring[0], y));
    }
    for (const auto& [a, b, c] : triangulate_polygon(contour, {})) {
        if (reversed) {
            builder.add_triangle(indices[c], indices[b], indices[a]);
        } else {
            builder.add_triangle(indices[a], indices[b], indices[c]);
        }
    }
}

} // namespace

void add_box(MeshBuilder& builder, const glm::dvec3& low, const glm::dvec3& high) {
    ALCOVE_ASSERT(low.x < high.x && low.y < high.y && low.z < high.z, "a box has a volume");
    const Ring bottom{{low.x, low.y, low.z},
                      {low.x, low.y, high.z},
                      {high.x, low.y, high.z},
                      {high.x, low.y, low.z}};
    Ring top = bottom;
    for (glm::dvec3& point : top) {
        point.y = high.y;
    }
    add_loft(builder, {bottom, top}, LoftEnds::capped);
}

Mesh make_box_mesh(std::string name, const glm::vec3& albedo, const glm::dvec3& low,
                   const glm::dvec3& high) {
    MeshBuilder builder;
    add_box(builder, low, high);
    return builder.finish(std::move(name), albedo, 0.0);
}

void add_loft(MeshBuilder& builder, const std::vector<Ring>& rings, LoftEnds ends) {
    ALCOVE_ASSERT(rings.size() >= (ends == LoftEnds::joined ? 3u : 2u), "a loft has rings");
    const std::size_t n = rings.front().size();
    std::vector<std::vector<std::uint32_t>> indices;
    for (std::size_t r = 0; r < rings.size(); ++r) {
        ALCOVE_ASSERT(rings[r].size() == n && n >= 3, "rings have equal size");
        std::vector<std::uint32_t> ring;
        for (std::size_t i = 0; i < n; ++i) {
            if (i > 0 && rings[r][i] == rings[r][i - 1]) {
                ring.push_back(ring.back());
            } else if (r > 0 && rings[r][i] == rings[r - 1][i]) {
                ring.push_back(indices.back()[i]);
            } else {
                ring.push_back(builder.add_point(rings[r][i]));
            }
        }
        indices.push_back(std::move(ring));
    }
    const std::size_t spans = ends == LoftEnds::joined ? rings.size() : rings.size() - 1;
    for (std::size_t r = 0; r < spans; ++r) {
        const std::vector<std::uint32_t>& from = indices[r];
        const std::vector<std::uint32_t>& to = indices[(r + 1) % rings.size()];
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t next = (i + 1) % n;
            builder.add_quad(from[i], from[next], to[next], to[i]);
        }
    }
    if (ends == LoftEnds::capped) {
        add_cap(builder, rings.front(), indices.front(), true);
        add_cap(builder, rings.back(), indices.back(), false);
    }
}

void add_extrusion(MeshBuilder& builder, const Plane& plane, const Contour& outline,
                   const std::vector<Contour>& holes, double depth) {
    ALCOVE_ASSERT(depth > 0.0, "an extrusion has a depth");
    const glm::dvec3 push = depth * glm::cross(plane.x, plane.y);
    std::vector<std::uint32_t> back;
    std::vector<std::uint32_t> front;
    const auto add_rim = [&](const Contour& contour, bool counter_clockwise) {
        const std::size_t first = back.size();
        for (const glm::dvec2& point : contour) {
            const glm::dvec3 place = plane.origin + point.x * plane.x + point.y * plane.y;
            back.push_back(builder.add_point(place));
            front.push_back(builder.add_point(place + push));
        }
        const bool flip = (compute_double_area(contour) > 0.0) != counter_clockwise;
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const std::size_t a = first + i;
            const std::size_t b = first + (i + 1) % contour.size();
            if (flip) {
                builder.add_quad(back[b], back[a], front[a], front[b]);
            } else {
                builder.add_quad(back[a], back[b], front[b], front[a]);
            }
        }
    };
    add_rim(outline, true);
    for (const Contour& hole : holes) {
        add_rim(hole, false);
    }
    for (const auto& [a, b, c] : triangulate_polygon(outline, holes)) {
        builder.add_triangle(front[a], front[b], front[c]);
        builder.add_triangle(back[c], back[b], back[a]);
    }
}

void add_lathe(MeshBuilder& builder, const Contour& profile, int segments) {
    std::vector<Ring> rings;
    for (const glm::dvec2& point : profile) {
        Ring ring;
        for (int i = 0; i < segments; ++i) {
            const double angle = -2.0 * std::numbers::pi * i / segments;
            ring.emplace_back(point.x * std::cos(angle), point.y, point.x * std::sin(angle));
        }
        rings.push_back(std::move(ring));
    }
    add_loft(builder, rings, LoftEnds::capped);
}

void add_lathe_at(MeshBuilder& builder, const glm::dvec3& foot, const Contour& profile,
                  int segments) {
    std::vector<Ring> rings;
    for (const glm::dvec2& point : profile) {
        Ring ring;
        for (int i = 0; i < segments; ++i) {
            const double angle = -2.0 * std::numbers::pi * i / segments;
            ring.push_back(
                foot + glm::dvec3(point.x * std::cos(angle), point.y, point.x * std::sin(angle)));
        }
        rings.push_back(std::move(ring));
    }
    add_loft(builder, rings, LoftEnds::capped);
}

void add_sweep(MeshBuilder& builder, const Contour& section, const std::vector<glm::dvec3>& path,
               const glm::dvec3& side) {
    ALCOVE_ASSERT(path.size() >= 2, "a path has two points");
    std::vector<Ring> rings;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const glm::dvec3& before = path[i == 0 ? 0 : i - 1];
        const glm::dvec3& after = path[i + 1 == path.size() ? i : i + 1];
        const glm::dvec3 tangent = glm::normalize(after - before);
        const glm::dvec3 normal = glm::cross(side, tangent);
        Ring ring;
        for (const glm::dvec2& point : section) {
            ring.push_back(path[i] + point.x * normal + point.y * side);
        }
        rings.push_back(std::move(ring));
    }
    add_loft(builder, rings, LoftEnds::capped);
}

void add_sheet(MeshBuilder& builder, const Sheet& sheet) {
    ALCOVE_ASSERT(sheet.columns > 0 && sheet.rows > 0, "a sheet has cells");
    const auto stride = static_cast<std::uint32_t>(sheet.rows + 1);
    std::vector<std::uint32_t> low;
    std::vector<std::uint32_t> high;
    for (int column = 0; column <= sheet.columns; ++column) {
        for (int row = 0; row <= sheet.rows; ++row) {
            const glm::dvec2 place = sheet.place(column, row);
            low.push_back(builder.add_point({place.x, sheet.lower(column, row), place.y}));
            high.push_back(builder.add_point({place.x, sheet.upper(column, row), place.y}));
        }
    }
    const auto at = [stride](int column, int row) {
        return static_cast<std::uint32_t>(column) * stride + static_cast<std::uint32_t>(row);
    };
    for (int column = 0; column < sheet.columns; ++column) {
        for (int row = 0; row < sheet.rows; ++row) {
            std::uint32_t a = at(column, row);
            std::uint32_t b = at(column, row + 1);
            std::uint32_t c = at(column + 1, row + 1);
            std::uint32_t d = at(column + 1, row);
            if (sheet.falls(column, row)) {
                const std::uint32_t first = a;
                a = b;
                b = c;
                c = d;
                d = first;
            }
            builder.add_quad(high[a], high[b], high[c], high[d]);
            builder.add_quad(low[a], low[d], low[c], low[b]);
        }
    }
    const auto add_side = [&](std::uint32_t a, std::uint32_t b) {
        builder.add_quad(low[a], low[b], high[b], high[a]);
    };
    for (int column = 0; column < sheet.columns; ++column) {
        add_side(at(column + 1, 0), at(column, 0));
        add_side(at(column, sheet.rows), at(column + 1, sheet.rows));
    }
    for (int row = 0; row < sheet.rows; ++row) {
        add_side(at(0, row), at(0, row + 1));
        add_side(at(sheet.columns, row + 1), at(sheet.columns, row));
    }
}

} // namespace alcove
