#pragma once
// Sets of sample points in the hemisphere, of which every pixel of a tile takes another one.
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in
// image space. 2009, section 3 (M x N low-discrepancy samples lambda_i omega_i); the tile is that
// of Segovia, Iehl, Mitanchey, Peroche. Non-interleaved deferred shading of interleaved sample
// patterns. 2006.

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace alcove {

/// `tile` x `tile` sets of `samples` points, one set behind the other: xyz = unit direction,
/// uniform over the hemisphere with z along the normal, w = step length in radii, uniform in [0,1].
/// Each set is a run of a scrambled Sobol sequence, so that it is well distributed and all sets
/// together as well; step lengths are a third, independent stratification.
[[nodiscard]] std::vector<glm::vec4> make_sample_sets(int tile, int samples);

/// For `#include "sample_set_counts.glsl"`, which methods/common/sample_sets.glsl needs.
[[nodiscard]] std::string make_sample_set_counts(int tile, int samples);

} // namespace alcove
