#pragma once
// Pedestals with mouldings, one closed solid each.

#include "core/contract/scene.hpp"

#include <string>

namespace alcove {

/// Rectangular, around the vertical through zero; its top is at `height` and measures 2 `half_x` by
/// 2 `half_z`. Foot and cornice stand out by up to 0.1 m and 0.06 m; the foot is sunk into the
/// ground by 0.05 m. `rounds` pieces a curve of the mouldings. Metres; asserts a height of 0.3 or
/// more.
[[nodiscard]] Mesh make_pedestal(std::string name, const glm::vec3& albedo, double height,
                                 double half_x, double half_z, int rounds);

} // namespace alcove
