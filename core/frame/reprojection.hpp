#pragma once
// Where a surface point of this frame was in the frame before. Composed in double relative to the
// two cameras, so that it is exact far from the world's zero.
// This work is based on: Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion
// using temporal coherence. 2010, equation (3): q = project(P_old V_old (p + F)).

#include "core/base/correspondence.hpp"
#include "core/frame/frame_view.hpp"
#include "core/gl/program.hpp"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// From view space now to view space one frame ago:
/// p_old = previous_from_view * p + previous_offset + previous_from_world * F.
struct Reprojection {
    glm::dmat3 previous_from_view{1.0};  ///< rotation
    glm::dvec3 previous_offset{0.0};     ///< where this camera stood, in the view before; metres
    glm::dmat3 previous_from_world{1.0}; ///< for the motion channel, which has world axes
    glm::dvec2 previous_tangents{1.0};   ///< of half the angles of view one frame ago
};

[[nodiscard]] Reprojection make_reprojection(const FrameView& view);

/// `position`: view space now; `motion`: p_old - p_new in world axes; both in metres. Returns the
/// view-space position one frame ago.
[[nodiscard]] glm::dvec3 reproject(const Reprojection& reprojection, const glm::dvec3& position,
                                   const glm::dvec3& motion);

/// Place on the previous image, (0,0) top left, (1,1) bottom right. Nothing behind that camera.
[[nodiscard]] std::optional<glm::dvec2> project_previous(const Reprojection& reprojection,
                                                         const glm::dvec3& previous_position);

/// Sets the uniforms of core/frame/reproject.glsl in the current program.
void set_reprojection_uniforms(const gl::Functions& gl, const gl::Program& program,
                               const Reprojection& reprojection);

/// What metrics need of a frame's geometry, from the full-precision G-buffer. Rows from the top.
struct SurfaceImages {
    Image eye_depth;   ///< one channel, metres; +infinity on the background
    Image normal;      ///< three channels, view space
    Image motion;      ///< three channels, metres
    Image instance_id; ///< one channel; 0 on the background
};

/// Valid where the point was inside the image, all four pixels around its place show the same
/// object, their depth (1/depth interpolated, exact on planes) agrees within 1 % and their normals'
/// cosine is over 0.9; then eroded by one pixel. Appeared where it was outside, or where of the 4 x
/// 4 pixels around its place none shows the same object at the depth that the point's tangent plane
/// has there, within 2 %. If the view has no history nothing is valid and every surface point has
/// appeared.
[[nodiscard]] Correspondence make_correspondence(const FrameView& view, const SurfaceImages& now,
                                                 const SurfaceImages& before);

} // namespace alcove
