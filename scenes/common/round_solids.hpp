#pragma once
// Round closed solids, added to a MeshBuilder with counter-clockwise outward winding: balls of
// nearly equal triangles, and tubes along any path. Metres. Others: solids.hpp.

#include "scenes/common/mesh_builder.hpp"

#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace alcove {

/// An icosahedron whose 20 faces are cut in four `subdivisions` times: 10 * 4^subdivisions + 2
/// points. `place` takes each from the unit sphere to where it is, without mirroring.
void add_ball(MeshBuilder& builder, int subdivisions,
              const std::function<glm::dvec3(const glm::dvec3& direction)>& place);

/// A smooth ball of radius 1 about 0. Its corners lie on the sphere, so that it is smaller by 2.4 %
/// of its volume at 3 subdivisions and by 9.3 % at 2.
[[nodiscard]] Mesh make_ball_mesh(std::string name, const glm::vec3& albedo, int subdivisions);

/// The tube of figure_shapes.hpp, its radii told apart from its points. Asserts one radius a point.
void add_tube(MeshBuilder& builder, const std::vector<glm::dvec3>& path,
              const std::vector<double>& radii, int around);

} // namespace alcove
