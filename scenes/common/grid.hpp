#pragma once
// A grid of 2^-20 m: places on it keep all their bits when a scene is moved by up to 2^32 m, and so
// do differences between them, which is what pictures are made of.

#include "core/contract/scene.hpp"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// The nearest place on the grid.
[[nodiscard]] inline glm::dvec3 snap_to_grid(const glm::dvec3& place) {
    constexpr double kCells = 1048576.0; // a metre
    return glm::round(place * kCells) / kCells;
}

inline void snap_cameras(Walkthrough& walkthrough) {
    for (Camera& camera : walkthrough.cameras) {
        camera.position = snap_to_grid(camera.position);
    }
}

} // namespace alcove
