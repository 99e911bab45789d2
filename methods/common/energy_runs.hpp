#pragma once
// A square map of energies cut into compact patches of equal energy: what lights that stand for
// many texels stand for. The patches are runs of a Hilbert curve.
// This work is based on: Hilbert. Über die stetige Abbildung einer Linie auf ein Flächenstück.
// 1891.

#include <cstddef>
#include <span>
#include <vector>

namespace alcove {

/// Indices x + side * y of a square of any side, in an order in which neighbours are neighbours
/// (but where the curve leaves a square whose side is no power of two).
[[nodiscard]] std::vector<std::size_t> order_along_curve(int side);

/// The ends of at most `count` runs of about equal sums: run i is [ends[i-1], ends[i]), the first
/// begins at 0, the last ends with the list. Runs that would hold nothing are left out, so that
/// energies above their share cost runs; with no energy at all there is no run.
[[nodiscard]] std::vector<std::size_t> cut_into_runs(std::span<const double> energies, int count);

} // namespace alcove
