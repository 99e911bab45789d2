#pragma once
// Low-discrepancy sequences for kernels.

#include <cstdint>

namespace alcove {

/// Radical inverse of `index` in `base`, in [0,1). Index 0 gives 0: kernels start at 1.
/// This work is based on: Halton. On the efficiency of certain quasi-random sequences of points.
/// 1960.
[[nodiscard]] double compute_radical_inverse(std::uint32_t index, std::uint32_t base);

} // namespace alcove
