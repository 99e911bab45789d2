#pragma once
// What makes a mesh a closed solid.

#include "core/contract/scene.hpp"

#include <cstddef>

namespace alcove {

struct SolidCheck {
    std::size_t open_edges = 0; ///< edges that do not lie between exactly two triangles
    double volume = 0.0;        ///< cubic metres; positive if triangles face outward
};
/// Corners at equal positions count as one.
[[nodiscard]] SolidCheck check_solid(const Mesh& mesh);

} // namespace alcove
