#pragma once
// Closed solids, added to a MeshBuilder with counter-clockwise outward winding. Each call adds
// points of its own, so that every edge of the solid belongs to exactly two of its triangles.
// Metres.

#include "scenes/common/mesh_builder.hpp"
#include "scenes/common/polygon.hpp"

#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace alcove {

/// Axis-aligned box. Asserts low < high.
void add_box(MeshBuilder& builder, const glm::dvec3& low, const glm::dvec3& high);

/// The same as a mesh of flat faces.
[[nodiscard]] Mesh make_box_mesh(std::string name, const glm::vec3& albedo, const glm::dvec3& low,
                                 const glm::dvec3& high);

using Ring = std::vector<glm::dvec3>;
enum class LoftEnds {
    capped, ///< the first and last ring are plane polygons and get closed
    joined, ///< the last ring is followed by the first: a torus
};
/// Skin over rings of equal size, each counter-clockwise seen from the side the rings go to. Equal
/// neighbouring points (the pole of a dome) are welded. Asserts two rings (three when joined) of
/// three points.
void add_loft(MeshBuilder& builder, const std::vector<Ring>& rings, LoftEnds ends);

/// A frame to draw plane contours in: x and y axes, unit and perpendicular.
struct Plane {
    glm::dvec3 origin{0.0};
    glm::dvec3 x{1.0, 0.0, 0.0};
    glm::dvec3 y{0.0, 1.0, 0.0};
};
/// The contour with its holes pushed from `plane` along x cross y by `depth` > 0.
void add_extrusion(MeshBuilder& builder, const Plane& plane, const Contour& outline,
                   const std::vector<Contour>& holes, double depth);

/// Surface of revolution around +Y. `profile` holds (radius, height) upwards, radii >= 0; ends off
/// the axis are capped.
void add_lathe(MeshBuilder& builder, const Contour& profile, int segments);
/// The same around the vertical through `foot`; heights above it.
void add_lathe_at(MeshBuilder& builder, const glm::dvec3& foot, const Contour& profile,
                  int segments);

/// A section swept along a plane path: its x axis points along the path's normal (`side` cross
/// tangent), its y axis along `side`, a unit vector perpendicular to the whole path. Corners are
/// mitred by halving the angle only, so keep the path smooth. Counter-clockwise section; path of
/// two points or more.
void add_sweep(MeshBuilder& builder, const Contour& section, const std::vector<glm::dvec3>& path,
               const glm::dvec3& side);

/// A sheet between two height fields over an (columns + 1) x (rows + 1) grid. `place` gives x and
/// z, `lower` and `upper` the heights at a grid point; x grows with the column, z with the row.
/// `falls(column, row)` chooses the diagonal of a cell: false from its first to its last corner,
/// true the other one.
struct Sheet {
    int columns = 1;
    int rows = 1;
    std::function<glm::dvec2(int column, int row)> place;
    std::function<double(int column, int row)> lower;
    std::function<double(int column, int row)> upper;
    std::function<bool(int column, int row)> falls;
};
void add_sheet(MeshBuilder& builder, const Sheet& sheet);

} // namespace alcove
