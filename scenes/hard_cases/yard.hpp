#pragma once
// A bit of everything that occlusion meets: boxes in contact, a sphere, a thin post and a long
// floor before open sky.

#include "core/contract/scene.hpp"

#include <memory>

namespace alcove {

struct YardSettings {
    double scale = 1.0; ///< of geometry, camera path, planes and radius, > 0
    glm::dvec3 origin{0.0};
    double far_m = 100.0; ///< of the camera, before scaling; > 80, where the floor ends
    double fov_y_degrees = 60.0;
};

/// Radius 0.4 m, camera about 4 m from the boxes at 1.6 m, near 0.1 m. Four frames: the camera at
/// A, 0.4 m aside at B, and back at A twice.
[[nodiscard]] std::unique_ptr<Scene> make_yard_case(const YardSettings& settings);

} // namespace alcove
