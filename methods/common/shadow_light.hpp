#pragma once
// Lights of a scene with the cameras of their shadow maps, for methods that draw maps of their own.

#include "core/contract/scene.hpp"
#include "core/frame/light_view.hpp"

#include <vector>

namespace alcove {

struct ShadowLight {
    bool is_point = false;
    glm::dvec3 place{0.0, 1.0, 0.0}; ///< unit direction to the light, or its position; world
    glm::vec3 color{0.0f};           ///< irradiance that faces it, or intensity at 1 m
    std::optional<SpotCone> cone;    ///< of points
    /// What its maps see: six faces around a point, one view of every other light. Not empty
    /// without shadows: what it lights is seen as well.
    std::vector<LightView> views;
    bool casts_shadow = false;
};

/// Directional lights first, as in `lights`. `sphere`: around what the maps must hold.
[[nodiscard]] std::vector<ShadowLight> list_shadow_lights(const Lights& lights,
                                                          const BoundingSphere& sphere);
[[nodiscard]] ShadowLight make_shadow_light(const DirectionalLight& light,
                                            const BoundingSphere& sphere);

} // namespace alcove
