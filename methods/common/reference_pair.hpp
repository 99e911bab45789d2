#pragma once
// Truth in two halves with independent randomisations, which tell its own noise.

#include "core/base/image.hpp"

#include <cstdint>

namespace alcove {

/// Images of equal size and channels. Their mean is the reference, RMS(a - b) / 2 its noise.
struct ReferencePair {
    Image a;
    Image b;
    std::uint64_t ray_count = 0; ///< rays cast for both
};

/// Mean of the halves.
[[nodiscard]] Image compute_mean(const ReferencePair& pair);
/// RMS(a - b) / 2: the standard error of the mean, over all pixels and channels.
[[nodiscard]] double compute_noise(const ReferencePair& pair);

} // namespace alcove
