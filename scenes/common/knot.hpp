#pragma once
// A statue without data: a trefoil knot of a carved rope.

#include "core/contract/scene.hpp"

namespace alcove {

/// Closed, about 1.2 m high and wide and 0.55 m deep, upright, in the x-y plane, its lowest point
/// on y = 0 and x = z = 0 the middle. `detail` scales the number of vertices, 30,800 at 1.
[[nodiscard]] Mesh make_knot(double detail, const glm::vec3& albedo);

} // namespace alcove
