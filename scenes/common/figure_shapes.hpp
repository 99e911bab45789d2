#pragma once
// Closed solids that bodies are made of. Metres.

#include "scenes/common/mesh_builder.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace alcove {

/// A limb's section at a height: half axes along (x) and across (z), and where its middle is.
struct Slice {
    double y = 0.0;
    double along = 0.0;
    double across = 0.0;
    double shift = 0.0; ///< along x
    double aside = 0.0; ///< along z
};
/// Skin over elliptic slices of `around` points, which ascend; both ends are capped.
void add_limb(MeshBuilder& builder, const std::vector<Slice>& slices, int around);
/// A smooth curve through the slices with `steps` pieces between two of them.
[[nodiscard]] std::vector<Slice> smooth_slices(const std::vector<Slice>& slices, int steps);

/// Half axes `size`; poles above and below.
void add_ellipsoid(MeshBuilder& builder, const glm::dvec3& centre, const glm::dvec3& size,
                   int around);

/// A point of a tube's middle line and the radius there, metres.
struct TubePoint {
    glm::dvec3 place{0.0};
    double radius = 0.01;
};
/// A round tube with capped ends; its sections do not twist. Asserts two points; neighbours stand
/// apart.
void add_tube(MeshBuilder& builder, const std::vector<TubePoint>& line, int around);

} // namespace alcove
