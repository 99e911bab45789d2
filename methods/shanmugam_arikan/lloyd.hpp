#pragma once
// Lloyd's iteration in space.
// This work is based on: Lloyd. Least squares quantization in PCM. 1982.

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace alcove {

/// For each point the index of its centre, below `count`, after `iterations` rounds of assigning
/// points to the nearest centre and moving centres to their points' mean. Starts from points spread
/// evenly over their order; ties go to the lower index, a centre that loses all its points stays.
/// Deterministic. Asserts 1 <= count <= points.size().
[[nodiscard]] std::vector<std::uint32_t> cluster_points(std::span<const glm::vec3> points,
                                                        std::size_t count, int iterations);

} // namespace alcove
