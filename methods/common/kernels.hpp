#pragma once
// Tables of sample points that estimators share.

#include <vector>

#include <glm/vec4.hpp>

namespace alcove {

enum class KernelDirections { uniform, cosine };
/// Samples outside the image: never blocked, or compared with the nearest pixel.
enum class KernelBorder { open, clamp };
/// How kernels are turned about their axis: not at all, by 16 angles that repeat in 4x4 pixels, or
/// by an angle a pixel.
enum class KernelRotation { off, tile, pixel };

/// Points in the hemisphere: xyz = unit direction with z along the normal, w = step length in
/// radii, uniform in [0,1). Halton points 1..n in bases 2 (elevation), 3 (azimuth), 5 (step
/// length).
[[nodiscard]] std::vector<glm::vec4> make_hemisphere_kernel(int samples,
                                                            KernelDirections directions);

/// As make_hemisphere_kernel with uniform directions, but uniform in volume: the step length is the
/// cube root. `is_whole_ball` spreads the directions over the sphere.
[[nodiscard]] std::vector<glm::vec4> make_ball_kernel(int samples, bool is_whole_ball);

/// Points on the unit disc, uniform in area: xy, z = w = 0. Halton points 1..n in bases 2 (radius)
/// and 3 (azimuth).
[[nodiscard]] std::vector<glm::vec4> make_disc_kernel(int samples);
/// The same, in pairs of a point and its mirror image: entries 2 k and 2 k + 1. An odd count ends
/// with a point without its pair.
[[nodiscard]] std::vector<glm::vec4> make_paired_disc_kernel(int samples);

} // namespace alcove
