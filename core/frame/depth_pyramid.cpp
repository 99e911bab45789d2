#include "core/frame/depth_pyramid.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace alcove {

DepthPyramid::DepthPyramid(std::vector<float> eye_depth, ImageSize size) {
    ALCOVE_ASSERT(eye_depth.size() == size.pixel_count(), "one depth a pixel");
    m_levels.push_back({size, std::move(eye_depth)});
    while (m_levels.back().size.pixel_count() > 1) {
        const Level& fine = m_levels.back();
        Level coarse{{(fine.size.width + 1) / 2, (fine.size.height + 1) / 2}, {}};
        coarse.farthest.assign(coarse.size.pixel_count(), 0.0f);
        for (int y = 0; y < fine.size.height; ++y) {
            const float* from = fine.farthest.data() + std::ptrdiff_t{y} * fine.size.width;
            float* to = coarse.farthest.data() + std::ptrdiff_t{y / 2} * coarse.size.width;
            for (int x = 0; x < fine.size.width; ++x) {
                to[x / 2] = std::max(to[x / 2], from[x]);
            }
        }
        m_levels.push_back(std::move(coarse));
    }
}

bool DepthPyramid::is_nearer(const ScreenBounds& bounds, double limit_m) const {
    // Start where the bounds span two squares at most.
    const int extent = std::max(bounds.right - bounds.left, bounds.top - bounds.bottom);
    std::size_t level = 0;
    while (level + 1 < m_levels.size() && extent >> level > 0) {
        ++level;
    }
    for (int y = bounds.bottom >> level; y <= bounds.top >> level; ++y) {
        for (int x = bounds.left >> level; x <= bounds.right >> level; ++x) {
            if (!is_nearer(level, x, y, bounds, limit_m)) {
                return false;
            }
        }
    }
    return true;
}

bool DepthPyramid::is_nearer(std::size_t level, int x, int y, const ScreenBounds& bounds,
                             double limit_m) const {
    const Level& squares = m_levels[level];
    if (x >= squares.size.width || y >= squares.size.height || x > bounds.right >> level ||
        x < bounds.left >> level || y > bounds.top >> level || y < bounds.bottom >> level) {
        return true;
    }
    const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(squares.size.width) +
                       static_cast<std::size_t>(x);
    if (squares.farthest[index] < limit_m) {
        return true;
    }
    if (level == 0) {
        return false;
    }
    return is_nearer(level - 1, 2 * x, 2 * y, bounds, limit_m) &&
           is_nearer(level - 1, 2 * x + 1, 2 * y, bounds, limit_m) &&
           is_nearer(level - 1, 2 * x, 2 * y + 1, bounds, limit_m) &&
           is_nearer(level - 1, 2 * x + 1, 2 * y + 1, bounds, limit_m);
}

double compute_depth_margin(const Camera& camera, const Precision& precision, double depth_m) {
    // Window depth is a + b / depth with b = f n / (f - n): its slope is b / depth^2. llvmpipe
    // interpolates it in float over the whole triangle, near or far: over one of 400 m that was
    // measured to cost 12.5 steps of 24 bits, whichever way the depth runs. 1 / w suffers alike.
    constexpr double kRounding = 32.0 * 0x1p-24;
    const double b = camera.far_m * camera.near_m / (camera.far_m - camera.near_m);
    const bool is_coarse = precision.raster_depth == RasterDepth::unorm16;
    const double step = kRounding + (is_coarse ? 0x1p-16 : 0.0);
    return 2.0 * step * depth_m * depth_m / b + 2e-5 * depth_m + 1e-4;
}

} // namespace alcove
