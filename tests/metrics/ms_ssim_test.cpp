// MS-SSIM beyond its check values: both low-passes, no NaN, masks at every scale.
#include "metrics/common/test_images.hpp"
#include "metrics/ms_ssim/ms_ssim.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

MetricResult evaluate(const MetricInput& input, const char* low_pass = "biorthogonal") {
    const MetricUnit unit = ms_ssim_unit();
    const std::vector<ParameterOverride> overrides{
        {"low_pass", low_pass, Provenance::command_line}};
    return unit.create(unit.parameters.resolve(overrides, {}))->evaluate(input);
}

TEST(MsSsim, TheLowPassShowsInItsValue) {
    const Image test = make_noisy_ramp();
    const Image reference = make_ramp();
    const double wavelet = *evaluate({test, reference}).value;
    const double mean = *evaluate({test, reference}, "mean").value;
    EXPECT_GT(std::abs(wavelet - mean), 1e-4);
    EXPECT_NEAR(wavelet, mean, 0.05);
}

TEST(MsSsim, AnInvertedImageIsZeroAndSaysHowManyScalesWereClamped) {
    Image checker({192, 192}, 1);
    Image inverted({192, 192}, 1);
    for (int y = 0; y < 192; ++y) {
        for (int x = 0; x < 192; ++x) {
            checker.at(x, y) = static_cast<float>((x / 8 + y / 8) % 2);
            inverted.at(x, y) = 1.0f - checker.at(x, y);
        }
    }
    for (const char* low_pass : {"biorthogonal", "mean"}) {
        const MetricResult result = evaluate({checker, inverted}, low_pass);
        EXPECT_EQ(*result.value, 0.0);
        EXPECT_EQ(result.extras.at(0).name, "clamped_scales");
        EXPECT_GE(result.extras.at(0).value, 1.0);
    }
}

TEST(MsSsim, AMaskFollowsTheImageToEveryScale) {
    const Image reference = make_ramp();
    // Wrong in the right half alone.
    Image test = reference;
    const Image noisy = make_noisy_ramp();
    Image left({256, 256}, 1);
    Image right({256, 256}, 1);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            if (x >= 128) {
                test.at(x, y) = noisy.at(x, y);
            }
            // 32 pixels a pixel of the coarsest scale, and its window reaches 5 of them.
            left.at(x, y) = x < 16 ? 1.0f : 0.0f;
            right.at(x, y) = x >= 128 ? 1.0f : 0.0f;
        }
    }
    const double all = *evaluate({test, reference}).value;
    EXPECT_LT(*evaluate({test, reference, nullptr, nullptr, &right}).value, all);
    // Its windows' centres lie 5 pixels and more from the border at every scale.
    const MetricResult border = evaluate({test, reference, nullptr, nullptr, &left});
    EXPECT_FALSE(border.value);
    EXPECT_NE(border.undefined_reason.find("scale"), std::string::npos);
}

} // namespace
} // namespace alcove
