#pragma once
// A growing triangle mesh in double precision. Points are shared by index, so that a solid whose
// points are added once is watertight by construction; vertices are split at creases only when the
// mesh is finished. Shapes: solids.hpp.

#include "core/contract/scene.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace alcove {

class MeshBuilder {
  public:
    /// Metres, object space. Returns the point's index.
    std::uint32_t add_point(const glm::dvec3& point);
    /// Counter-clockwise seen from outside. A triangle that names a point twice (at the pole of a
    /// lathe) is left out. Asserts that the points exist.
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    /// Split along a-c. Counter-clockwise seen from outside.
    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);

    [[nodiscard]] const std::vector<glm::dvec3>& points() const noexcept { return m_points; }
    [[nodiscard]] const std::vector<std::array<std::uint32_t, 3>>& triangles() const noexcept {
        return m_triangles;
    }

    /// Normals are averages, weighted by the angle at the corner, over the adjacent faces that are
    /// turned less than `crease_degrees` (in [0,180]) away from the corner's own face: 0 gives flat
    /// faces, 180 a smooth surface with one vertex a point. Points without triangles are dropped.
    /// `closed` is set if every edge joins two triangles that turn the same way and the mesh
    /// encloses a positive volume. Asserts that there is a triangle.
    [[nodiscard]] Mesh finish(std::string name, const glm::vec3& albedo,
                              double crease_degrees) const;

  private:
    [[nodiscard]] bool is_closed() const;

    std::vector<glm::dvec3> m_points;
    std::vector<std::array<std::uint32_t, 3>> m_triangles;
};

} // namespace alcove
