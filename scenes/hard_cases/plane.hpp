#pragma once
// A plane that is infinite for every camera that looks at it: it blocks nothing of itself, so a
// hemisphere estimator must leave it open at any distance, radius, tilt and angle of view.

#include "core/contract/scene.hpp"

#include <memory>

namespace alcove {

struct PlaneSettings {
    double distance_m = 5.0;   ///< along the view axis, > 0
    double tilt_degrees = 0.0; ///< about the x axis, the top leans away; in [0, 90)
    double fov_y_degrees = 60.0;
    double half_m = 1000.0; ///< of plane to each side of the view axis, along its slope
};

/// Camera at 0 looking along -z, near 0.001 m and far 10 km; radius 0.5 m.
[[nodiscard]] std::unique_ptr<Scene> make_plane_case(const PlaneSettings& settings);

} // namespace alcove
