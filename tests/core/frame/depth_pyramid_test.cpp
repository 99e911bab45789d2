#include "core/frame/depth_pyramid.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace alcove {
namespace {

TEST(DepthPyramidTest, AnswersAsALoopOverThePixelsDoes) {
    std::mt19937 random(3);
    for (const ImageSize size : {ImageSize{1, 1}, ImageSize{37, 21}, ImageSize{64, 5}}) {
        std::vector<float> depth(size.pixel_count());
        for (float& value : depth) {
            value = random() % 400 == 0 ? std::numeric_limits<float>::infinity()
                                        : static_cast<float>(random() % 100);
        }
        const DepthPyramid pyramid(depth, size);
        int nearer = 0;
        for (int i = 0; i < 3000; ++i) {
            ScreenBounds bounds;
            bounds.left = static_cast<int>(random() % static_cast<unsigned>(size.width));
            bounds.bottom = static_cast<int>(random() % static_cast<unsigned>(size.height));
            bounds.right = std::min(bounds.left + static_cast<int>(random() % 9), size.width - 1);
            bounds.top = std::min(bounds.bottom + static_cast<int>(random() % 9), size.height - 1);
            const double limit = 50.0 + static_cast<double>(random() % 60);
            bool expected = true;
            for (int y = bounds.bottom; y <= bounds.top; ++y) {
                for (int x = bounds.left; x <= bounds.right; ++x) {
                    expected = expected && depth[static_cast<std::size_t>(y * size.width + x)] <
                                               static_cast<float>(limit);
                }
            }
            ASSERT_EQ(pyramid.is_nearer(bounds, limit), expected) << i;
            nearer += expected ? 1 : 0;
        }
        if (size.pixel_count() > 1) {
            EXPECT_GT(nearer, 100);
            EXPECT_LT(nearer, 2900);
        }
    }
}

TEST(DepthPyramidTest, TheMarginGrowsWithTheDistanceAndWithCoarserDepth) {
    Camera camera;
    camera.near_m = 0.1;
    camera.far_m = 2000.0;
    Precision coarse;
    coarse.raster_depth = RasterDepth::unorm16;
    const double at_ten = compute_depth_margin(camera, {}, 10.0);
    EXPECT_GT(compute_depth_margin(camera, {}, 100.0), at_ten);
    EXPECT_GT(compute_depth_margin(camera, coarse, 10.0), at_ten);
    // Two steps of 2^-16 at 10 m: 2 * 100 * 2^-16 / 0.1 m.
    EXPECT_GT(compute_depth_margin(camera, coarse, 10.0), 0.0305);
}

} // namespace
} // namespace alcove
