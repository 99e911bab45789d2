#pragma once
// Cameras in double precision. Right-handed, +Y up, looking along -Z of view space, as glTF.
// Everything the GPU sees is made relative to the camera here, so that no shader ever holds an
// absolute world position.

#include "core/base/image.hpp"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// A perspective camera: where it stands, how it is turned, what it sees.
struct Camera {
    glm::dvec3 position{0.0};                  ///< world, metres
    glm::dmat3 world_from_view{1.0};           ///< rotation; columns: right, up, backward
    double fov_y_radians = 1.0471975511965976; ///< full vertical angle, in (0, pi)
    double near_m = 0.1;   ///< distance of the near plane along the view axis, > 0
    double far_m = 1000.0; ///< distance of the far plane, > near
};

/// A camera at `position` that looks at `target`. `up` need not be perpendicular to the view axis.
/// Throws InputError if target equals position, or up is parallel to the view axis, or anything is
/// not finite.
[[nodiscard]] Camera make_look_at_camera(const glm::dvec3& position, const glm::dvec3& target,
                                         const glm::dvec3& up, double fov_y_radians, double near_m,
                                         double far_m);

/// Throws InputError, naming `where`, unless all numbers are finite, fov is in (0, 180) degrees and
/// 0 < near < far.
void check_camera(const Camera& camera, std::string_view where);

/// Object-to-view matrix relative to the camera: rotation of the view times (object_to_world with
/// the camera's position subtracted), composed in double.
[[nodiscard]] glm::dmat4 compute_view_from_object(const Camera& camera,
                                                  const glm::dmat4& object_to_world);

/// Clip-from-view matrix for an image of this size. `reversed`: depth 1 at near and 0 at far for a
/// [0,1] clip range; otherwise the OpenGL default, -1 at near and 1 at far.
[[nodiscard]] glm::dmat4 compute_projection(const Camera& camera, ImageSize size, bool reversed);

/// tan of half the horizontal and vertical angle of view for an image of this size.
[[nodiscard]] glm::dvec2 compute_tangents(const Camera& camera, ImageSize size);

/// World direction, not normalised, with unit length along the view axis, through a point of the
/// image in pixels
/// ((0.5, 0.5) is the centre of the top left pixel).
[[nodiscard]] glm::dvec3 compute_pixel_direction(const Camera& camera, ImageSize size,
                                                 const glm::dvec2& pixel);

} // namespace alcove
