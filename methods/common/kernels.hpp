#pragma once
// Tables of sample points that estimators share.

#include <vector>

#include <glm/vec4.hpp>

namespace alcove {

enum class KernelDirections { uniform, cosine };
/// Samples outside the image: never blocked, or compared with the nearest pixel.
enum class KernelBorder { open, clamp };

/// Points in the hemisphere: xyz = unit direction with z along the normal, w = step length in
/// radii, uniform in [0,1). Halton points 1..n in bases 2 (elevation), 3 (azimuth), 5 (step
/// length).
[[nodiscard]] std::vector<glm::vec4> make_hemisphere_kernel(int samples,
                                                            KernelDirections directions);

/// Points on the unit disc, uniform in area: xy, z = w = 0. Halton points 1..n in bases 2 (radius)
/// and 3 (azimuth).
[[nodiscard]] std::vector<glm::vec4> make_disc_kernel(int samples);

} // namespace alcove
