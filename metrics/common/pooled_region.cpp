#include "metrics/common/pooled_region.hpp"

#include <algorithm>

namespace alcove {

PooledRegion::PooledRegion(const Image* mask, ImageSize size, int offset)
    : m_mask(mask), m_size(size), m_offset(offset), m_count(size.pixel_count()) {
    if (mask == nullptr) {
        return;
    }
    ALCOVE_ASSERT(size.width + offset <= mask->width() && size.height + offset <= mask->height(),
                  "a region inside the mask");
    m_count = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            m_count += is_counted(x, y) ? 1u : 0u;
        }
    }
}

template <class Value>
double PooledRegion::sum(int y, const Value* values) const {
    double sum = 0.0;
    for (int x = 0; x < m_size.width; ++x) {
        if (is_counted(x, y)) {
            sum += static_cast<double>(values[x]);
        }
    }
    return sum;
}

double PooledRegion::sum_row(int y, const float* values) const {
    return sum(y, values);
}

double PooledRegion::sum_row(int y, const double* values) const {
    return sum(y, values);
}

double PooledRegion::compute_mean(const std::vector<double>& row_sums) const {
    ALCOVE_ASSERT(m_count > 0, "something to pool");
    double sum = 0.0;
    for (const double row : row_sums) {
        sum += row;
    }
    return sum / static_cast<double>(m_count);
}

double PooledRegion::compute_mean(const Image& map) const {
    ALCOVE_ASSERT(map.size() == m_size && map.channels() == 1, "a map of the region");
    const auto width = static_cast<std::size_t>(m_size.width);
    std::vector<double> rows;
    for (int y = 0; y < m_size.height; ++y) {
        rows.push_back(sum_row(y, map.values().data() + static_cast<std::size_t>(y) * width));
    }
    return compute_mean(rows);
}

void PooledRegion::report(MetricResult& result) const {
    if (m_mask == nullptr) {
        return;
    }
    result.counted_pixels = m_count;
    result.ignored_pixels = m_size.pixel_count() - m_count;
    if (m_count == 0) {
        result.undefined_reason = "the mask counts none of the pixels that are pooled";
    }
}

std::vector<float> list_counted(const Image& map, const PooledRegion& region) {
    ALCOVE_ASSERT(map.size() == region.size() && map.channels() == 1, "a map of the region");
    std::vector<float> values;
    values.reserve(region.count());
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            if (region.is_counted(x, y)) {
                values.push_back(map.at(x, y));
            }
        }
    }
    return values;
}

Image halve_mask(const Image& mask) {
    Image half({(mask.width() + 1) / 2, (mask.height() + 1) / 2}, 1);
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            half.at(x / 2, y / 2) = std::max(half.at(x / 2, y / 2), mask.at(x, y));
        }
    }
    return half;
}

} // namespace alcove
