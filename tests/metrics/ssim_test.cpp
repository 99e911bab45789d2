// SSIM beyond its check values: symmetry, region, bounds, and a window that is restated here in two
// dimensions.
#include "core/base/error.hpp"
#include "metrics/ssim/ssim.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alcove {
namespace {

MetricResult evaluate(const Image& test, const Image& reference) {
    const MetricUnit unit = ssim_unit();
    return unit.create(unit.parameters.resolve({}, {}))->evaluate({test, reference});
}

Image make_noise(ImageSize size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    Image image(size, 1);
    for (float& value : image.values()) {
        value = uniform(random);
    }
    return image;
}

/// One window, from the definition: 121 weights, two passes (means, then central moments).
double compute_window(const Image& x, const Image& y, int left, int top) {
    double weights[11][11];
    double total = 0.0;
    for (int j = 0; j < 11; ++j) {
        for (int i = 0; i < 11; ++i) {
            weights[j][i] = std::exp(-((i - 5) * (i - 5) + (j - 5) * (j - 5)) / (2.0 * 1.5 * 1.5));
            total += weights[j][i];
        }
    }
    const auto average = [&](auto value) {
        double sum = 0.0;
        for (int j = 0; j < 11; ++j) {
            for (int i = 0; i < 11; ++i) {
                sum += weights[j][i] / total * value(left + i, top + j);
            }
        }
        return sum;
    };
    const double mx = average([&](int i, int j) { return static_cast<double>(x.at(i, j)); });
    const double my = average([&](int i, int j) { return static_cast<double>(y.at(i, j)); });
    const auto dx = [&](int i, int j) { return static_cast<double>(x.at(i, j)) - mx; };
    const auto dy = [&](int i, int j) { return static_cast<double>(y.at(i, j)) - my; };
    const double vx = average([&](int i, int j) { return dx(i, j) * dx(i, j); });
    const double vy = average([&](int i, int j) { return dy(i, j) * dy(i, j); });
    const double cov = average([&](int i, int j) { return dx(i, j) * dy(i, j); });
    const double c1 = 1e-4;
    const double c2 = 9e-4;
    return (2.0 * mx * my + c1) * (2.0 * cov + c2) / ((mx * mx + my * my + c1) * (vx + vy + c2));
}

TEST(Ssim, EachMapValueIsItsWindowFromTheDefinition) {
    const Image x = make_noise({29, 17}, 1);
    const Image y = make_noise({29, 17}, 2);
    const MetricResult result = evaluate(x, y);
    ASSERT_EQ(result.map->size(), (ImageSize{19, 7}));
    EXPECT_EQ(result.map_offset, 5);
    double sum = 0.0;
    for (int top = 0; top < 7; ++top) {
        for (int left = 0; left < 19; ++left) {
            const double expected = compute_window(x, y, left, top);
            // The map is float.
            ASSERT_NEAR(result.map->at(left, top), expected, 1e-6);
            sum += expected;
        }
    }
    // Sums in another order, in double.
    EXPECT_NEAR(*result.value, sum / (19.0 * 7.0), 1e-12);
}

TEST(Ssim, IsSymmetricInItsImages) {
    const Image x = make_noise({40, 30}, 3);
    const Image y = make_noise({40, 30}, 4);
    EXPECT_DOUBLE_EQ(*evaluate(x, y).value, *evaluate(y, x).value);
    EXPECT_EQ(*evaluate(x, x).value, 1.0);
}

TEST(Ssim, OneWindowIsTheSmallestImage) {
    const Image x = make_noise({11, 11}, 5);
    const Image y = make_noise({11, 11}, 6);
    const MetricResult result = evaluate(x, y);
    ASSERT_EQ(result.map->size(), (ImageSize{1, 1}));
    EXPECT_NEAR(*result.value, compute_window(x, y, 0, 0), 1e-12);
    for (const ImageSize size : {ImageSize{10, 10}, ImageSize{10, 40}, ImageSize{40, 10}}) {
        const Image small(size, 1, 0.5f);
        EXPECT_THROW(static_cast<void>(evaluate(small, small)), InputError) << size.width;
    }
}

TEST(Ssim, NegatedStructureIsNegative) {
    const Image x = make_noise({32, 32}, 7);
    Image y = x;
    for (float& value : y.values()) {
        value = 1.0f - value;
    }
    EXPECT_LT(*evaluate(x, y).value, -0.5);
    EXPECT_GE(*evaluate(x, y).value, -1.0);
}

} // namespace
} // namespace alcove
