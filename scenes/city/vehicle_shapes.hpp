#pragma once
// What cars and trams look like: metres, front towards +x, zero on the ground below their middle.

#include "scenes/city/kit.hpp"

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace alcove::city {

inline constexpr double kCarWheel = 0.31;  ///< radius
inline constexpr double kTramWheel = 0.33; ///< radius

/// A tyre with a bar across its disk, around z: its turning can be seen. From two steps on the disk
/// has holes.
[[nodiscard]] Mesh make_wheel(const Kit& kit, double radius);
/// Adds the meshes of a car without its wheels, to be placed together; 4.2 m long.
[[nodiscard]] std::vector<std::size_t> add_car(Kit& kit, const glm::vec3& paint);
/// The same of a tram, 16 m long, in one piece.
[[nodiscard]] std::vector<std::size_t> add_tram(Kit& kit);

} // namespace alcove::city
