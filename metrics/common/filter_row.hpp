#pragma once
// Weighted sums of neighbouring rows, or of one row's neighbouring columns: one axis of a separable
// filter.

#include "metrics/common/flip_filters.hpp"

#include <cstddef>

namespace alcove {

/// Rows are filtered in blocks of this many floats: what `count` is a multiple of.
inline constexpr std::size_t kFilterBlock = 32;

/// even: the weight of a tap is that of its distance. odd: the weights before the centre change
/// sign. Products are added from the first tap to the last in single precision, as the published
/// implementation of FLIP does: on constants a second derivative leaves 1e-8 in place of 0, of
/// which FLIP takes a square root, so that the order shows in its means (3e-5).
enum class FilterKind { even, odd };

/// `taps` points to the centre of 2 radius + 1 pointers to `count` floats. `add`: to what is in
/// `out`, which overlaps none of them.
void filter_row(FilterKind kind, const HalfFilter& filter, const float* const* taps,
                std::size_t count, bool add, float* out);

} // namespace alcove
