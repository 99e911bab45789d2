#pragma once
// A light as a camera: what its shadow map or reflective shadow map sees. Square images.

#include "core/contract/scene.hpp"
#include "core/frame/gbuffer_part.hpp"

#include <array>

namespace alcove {

struct LightView {
    Camera camera; ///< its angle of view counts for perspective views alone
    /// Metres from the middle to the edge of what an orthographic view sees; 0: perspective.
    double half_extent_m = 0.0;
    [[nodiscard]] bool is_orthographic() const { return half_extent_m > 0.0; }
};

/// Clip-from-view matrix in the OpenGL default range, -1 at near and 1 at far.
[[nodiscard]] glm::dmat4 compute_projection(const LightView& view);

/// Side of what one texel of `side` texels stands for on a surface that faces the light, metres,
/// `along_m` down the view axis: 2 tan(fov / 2) along / side, or constant from infinitely far away.
[[nodiscard]] double compute_texel_m(const LightView& view, int side, double along_m);

/// All of the sphere, along the light. `margin`: factor on the radius, for what moves.
[[nodiscard]] LightView look_along(const DirectionalLight& light, const BoundingSphere& sphere,
                                   double margin = 1.05);
/// A spot light's cone up to the far side of the sphere. Asserts a cone.
[[nodiscard]] LightView look_along(const PointLight& light, const BoundingSphere& sphere);
/// Faces +x -x +y -y +z -z, in world axes, of a cube around the light.
[[nodiscard]] std::array<LightView, 6> look_around(const PointLight& light,
                                                   const BoundingSphere& sphere);

} // namespace alcove
