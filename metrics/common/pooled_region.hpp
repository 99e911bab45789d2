#pragma once
// Which pixels a metric pools: all of a grid, or those that a mask counts.

#include "core/contract/metric.hpp"

#include <vector>

namespace alcove {

class PooledRegion {
  public:
    /// A grid of `size` whose first pixel is the mask's pixel (offset, offset). `mask` may be null
    /// and must outlive the region. Asserts that the grid lies in the mask.
    PooledRegion(const Image* mask, ImageSize size, int offset = 0);

    [[nodiscard]] ImageSize size() const noexcept { return m_size; }
    [[nodiscard]] std::size_t count() const noexcept { return m_count; }
    [[nodiscard]] bool is_counted(int x, int y) const {
        return m_mask == nullptr || m_mask->at(x + m_offset, y + m_offset) != 0.0f;
    }
    /// Sum, from left to right in double, of the counted ones of a row's values.
    [[nodiscard]] double sum_row(int y, const float* values) const;
    [[nodiscard]] double sum_row(int y, const double* values) const;
    /// Sum of the rows, from top to bottom, over the count. Asserts that it is not 0.
    [[nodiscard]] double compute_mean(const std::vector<double>& row_sums) const;
    /// Mean of the counted ones of a map that has the region's size. Asserts that there are any.
    [[nodiscard]] double compute_mean(const Image& map) const;
    /// Writes the counts where there is a mask, and the reason where it counts nothing.
    void report(MetricResult& result) const;

  private:
    template <class Value>
    [[nodiscard]] double sum(int y, const Value* values) const;

    const Image* m_mask;
    ImageSize m_size;
    int m_offset;
    std::size_t m_count;
};

/// The counted ones of a map that has the region's size.
[[nodiscard]] std::vector<float> list_counted(const Image& map, const PooledRegion& region);

/// The mask of the image at half the size, rounded up: a pixel is counted where one of the four
/// that it stands for is.
[[nodiscard]] Image halve_mask(const Image& mask);

} // namespace alcove
