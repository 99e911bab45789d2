#pragma once
// Ambient occlusion where it is known without rays: closed forms, and double quadrature of the
// exact visibility that the closed forms are held against. All values are the blocked share, 0 =
// open.

#include "core/base/target.hpp"

#include <functional>

#include <glm/vec3.hpp>

namespace alcove {

/// Weight of a hit at `relative` = distance / radius in [0,1].
[[nodiscard]] double compute_falloff(Falloff falloff, double relative);

/// Mean over the hemisphere around +z of `blocked(direction)`, by the midpoint rule on `steps` x
/// `steps` cells of equal weight (squared sine or cosine of the elevation, azimuth). Indicator
/// functions come out within 2 / steps^1.5 or so.
[[nodiscard]] double integrate_hemisphere(const std::function<double(const glm::dvec3&)>& blocked,
                                          Weighting weighting, int steps);

/// A wall that stands on the receiver's plane at `k` radii, higher and wider than the reach;
/// falloff none. With the cosine, directions projected on the plane fill the unit disc evenly
/// (Malley), and hits nearer than the radius are those beyond the chord x = k: a segment of the
/// disc. Uniform: half a spherical cap of height 1 - k.
[[nodiscard]] double compute_wall_occlusion(double k, Weighting weighting);

/// The same for any falloff: the hit along a direction is k / x radii away, so it is one integral
/// over x.
[[nodiscard]] double integrate_wall_occlusion(double k, Falloff falloff, Weighting weighting);

/// Two walls at right angles at `kx` and `ky` radii; falloff none, cosine: both segments less the
/// part they share.
[[nodiscard]] double compute_two_walls_occlusion(double kx, double ky);

/// A sphere wholly above the receiver's plane and within reach; falloff none, cosine: sin^2(half
/// angle) cos(angle between its centre and the normal). `to_center` in metres, z along the normal.
[[nodiscard]] double compute_sphere_occlusion(const glm::dvec3& to_center, double sphere_radius);

} // namespace alcove
