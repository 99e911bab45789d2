#pragma once
// What ssim and ms_ssim are made of: luminance, contrast and structure in an 11 x 11 Gaussian
// window. This work is based on: Wang, Bovik, Sheikh, Simoncelli. Image quality assessment: from
// error visibility to structural similarity. 2004.

#include "metrics/common/pooled_region.hpp"

namespace alcove {

/// Half of the window: images of one channel lose so many pixels at each border.
inline constexpr int kStructureRadius = 5;

/// whole: l c s, which is SSIM. contrast_structure: c s alone.
enum class StructureTerm { whole, contrast_structure };

/// The windows that lie wholly in an image of `size`, counted by their centres. Asserts sides of
/// 2 kStructureRadius + 1 or more.
[[nodiscard]] PooledRegion make_structure_region(const Image* mask, ImageSize size);

/// Mean of a term over the region, whose count must not be 0; on codes in [0,1] with sigma 1.5,
/// normalised in double, K1 0.01, K2 0.03, L 1, population variances. `map`, where not null,
/// receives the term of each window.
[[nodiscard]] double compute_structure(const Image& test, const Image& reference,
                                       StructureTerm term, const PooledRegion& region, Image* map);

} // namespace alcove
