#pragma once
// Furniture. Every prop stands about 0 on the floor y = 0, sunk by kSink, with its back towards -z,
// within 0.4 m to each side and 0.3 m to back and front.

#include "core/contract/scene.hpp"

#include <vector>

namespace alcove::closed_room {

/// Solids that meet reach this deep into each other, metres: no two faces in one plane.
inline constexpr double kSink = 0.02;

[[nodiscard]] Mesh make_table(); ///< 1.4 m by 0.8 m, the one prop that is larger
[[nodiscard]] std::vector<Mesh> make_props();

} // namespace alcove::closed_room
