#pragma once
// Plane polygons with holes, cut into triangles: the faces of walls with arches and windows, and
// the caps of sweeps.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace alcove {

using Contour = std::vector<glm::dvec2>;

/// Twice the enclosed area; positive for a counter-clockwise contour.
[[nodiscard]] double compute_double_area(const Contour& contour);

/// Points of a circular or elliptic arc around `centre`, both ends included. Angles in radians from
/// +x.
[[nodiscard]] Contour make_arc(const glm::dvec2& centre, const glm::dvec2& radii, double from,
                               double to, int segments);

/// Triangles of a simple polygon with simple holes that touch neither each other nor the outline,
/// counter-clockwise, as indices into the points of outline, first hole, second hole, ... Either
/// orientation is accepted. Every point is a corner of some triangle and no point lies within a
/// triangle's edge unless the contour itself doubles back, so that the result meets a wall raised
/// on the contours without a crack. Quadratic in the number of points. Asserts that the contours
/// are simple. This work is based on: D. Eberly. Triangulation by Ear Clipping. 2002.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>>
triangulate_polygon(const Contour& outline, const std::vector<Contour>& holes);

} // namespace alcove
