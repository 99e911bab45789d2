// recovery_frames on points that come into view and whose error then goes a known way.
#include "tests/metrics/temporal_sequences.hpp"

#include <cmath>
#include <functional>

namespace alcove {
namespace {

constexpr ImageSize kSize{48, 36};
constexpr int kFrames = 32;
constexpr int kAppears = 8;
/// Ages 0 to 23 are seen.
constexpr int kOldest = kFrames - 1 - kAppears;

/// In frame kAppears the first `pixels` pixels, row by row, come into view; there the error is
/// `steady` x `ratio(age)`, elsewhere `steady`.
std::vector<PlantedFrame> plant_recovery(int pixels, const std::function<double(int)>& ratio,
                                         double steady = 0.1, ImageSize size = kSize) {
    const auto count = static_cast<std::size_t>(pixels);
    auto frames = plant_errors(size, PlantedMotion::still, kFrames, steady, [&](int t) {
        Image error(size, 1, 1.0f);
        for (std::size_t i = 0; t >= kAppears && i < count; ++i) {
            error.values()[i] = static_cast<float>(ratio(t - kAppears));
        }
        return error;
    });
    for (std::size_t i = 0; i < count; ++i) {
        frames[kAppears].to_previous.valid.values()[i] = 0.0f;
        frames[kAppears].to_previous.appeared.values()[i] = 1.0f;
    }
    return frames;
}

std::function<double(int)> decay(double keep) {
    return [keep](int age) { return 1.0 + 2.0 * std::pow(keep, age); };
}

MetricResult get_recovery(const std::vector<PlantedFrame>& frames,
                          const std::vector<ParameterOverride>& overrides = {}) {
    return follow_planted(*make_temporal("recovery_frames", overrides), frames).back().value();
}

void expect_undefined(const MetricResult& result, const std::string& reason) {
    EXPECT_FALSE(result.value.has_value());
    EXPECT_NE(result.undefined_reason.find(reason), std::string::npos) << result.undefined_reason;
}

TEST(RecoveryFrames, IsTheFirstAgeWithinToleranceOfTheSteadyError) {
    // 2 x 0.7^n <= 0.1 first at n = 9 (log 0.05 / log 0.7 = 8.4).
    EXPECT_EQ(*get_recovery(plant_recovery(288, decay(0.7))).value, 9.0);
    // 2 x 0.7^n <= 1 first at n = 2.
    EXPECT_EQ(*get_recovery(plant_recovery(288, decay(0.7)), {{"tolerance", "2"}}).value, 2.0);
    // Never worse than what was always in view.
    EXPECT_EQ(*get_recovery(plant_recovery(288, decay(0.0)), {{"tolerance", "3.5"}}).value, 0.0);
}

TEST(RecoveryFrames, ARelapseCounts) {
    const auto frames =
        plant_recovery(288, [](int age) { return age < 3 || age == 12 ? 3.0 : 1.0; });
    EXPECT_EQ(*get_recovery(frames).value, 13.0);
}

TEST(RecoveryFrames, IsUndefinedWhereTheErrorNeverFalls) {
    const auto frames = plant_recovery(288, [](int) { return 2.0; });
    expect_undefined(get_recovery(frames), "more than " + std::to_string(kOldest) + " frames");
    expect_undefined(get_recovery(frames, {{"longest_age", "10"}}), "more than 10 frames");
}

TEST(RecoveryFrames, AgesOverTheLongestArePooled) {
    // RMS over ages 4 to 23 of an error that is 3 at ages up to 5, else 1:
    // sqrt((2 x 9 + 18) / 20) = 1.34.
    const auto frames = plant_recovery(288, [](int age) { return age <= 5 ? 3.0 : 1.0; });
    EXPECT_EQ(*get_recovery(frames, {{"longest_age", "4"}, {"tolerance", "1.35"}}).value, 4.0);
    expect_undefined(get_recovery(frames, {{"longest_age", "4"}, {"tolerance", "1.33"}}),
                     "more than 4 frames");
}

TEST(RecoveryFrames, IsUndefinedWhereTooLittleCameIntoViewOrTooLittleStayed) {
    expect_undefined(get_recovery(plant_recovery(0, decay(0.5))), "too few points came into view");
    expect_undefined(get_recovery(plant_recovery(63, decay(0.5))), "too few points came into view");
    EXPECT_TRUE(get_recovery(plant_recovery(64, decay(0.5))).value.has_value());
    const int all = kSize.width * kSize.height;
    expect_undefined(get_recovery(plant_recovery(all - 3, decay(0.5)), {{"least_pixels", "49"}}),
                     "no steady error");
    // 3 pixels in each of the second half's 16 frames.
    EXPECT_TRUE(get_recovery(plant_recovery(all - 3, decay(0.5)), {{"least_pixels", "48"}})
                    .value.has_value());
}

TEST(RecoveryFrames, BackgroundCountsNothing) {
    auto frames = plant_recovery(288, decay(0.7));
    for (PlantedFrame& frame : frames) {
        for (int x = 0; x < kSize.width; ++x) {
            frame.surface.at(x, kSize.height - 1) = 0.0f;
            frame.test.at(x, kSize.height - 1) = 50.0f;
            frame.surface.at(x, 0) = 0.0f;
            frame.test.at(x, 0) = 50.0f;
        }
    }
    EXPECT_EQ(*get_recovery(frames).value, 9.0);
}

TEST(RecoveryFrames, AgesAreCarriedAlongTheMotion) {
    // The picture moves 1 pixel to the left: what stands x pixels from the right border came into
    // view x frames ago. 4 x 0.5^n <= 0.1 first at n = 6.
    std::vector<PlantedFrame> frames =
        plant_errors(kSize, PlantedMotion::pan_one_pixel, kFrames, 0.1, [](int t) {
            Image error(kSize, 1, 1.0f);
            for (int y = 0; y < kSize.height; ++y) {
                for (int x = kSize.width - t; x < kSize.width; ++x) {
                    error.at(x, y) += static_cast<float>(4.0 * std::pow(0.5, kSize.width - 1 - x));
                }
            }
            return error;
        });
    EXPECT_EQ(*get_recovery(frames).value, 6.0);
}

TEST(RecoveryFrames, IsToldOnTheLastFrameOnly) {
    const auto metric = make_temporal("recovery_frames");
    const auto results = follow_planted(*metric, plant_recovery(288, decay(0.7)));
    for (std::size_t t = 0; t < results.size(); ++t) {
        EXPECT_EQ(results[t].has_value(), t + 1 == results.size()) << t;
    }
}

TEST(RecoveryFrames, DebiasingTakesOutTheNoiseThatMakesRecoveryLookFaster) {
    // Errors of 0.05 x (1 + 2.56 x 0.25^age). Without noise 2.56 x 0.25^n <= 0.1 first at n = 3.
    // With the mean's noise, 0.08^2 / 2 = 0.0032 on each square, the bound is
    // 1.1^2 (0.0025 + 0.0032) = 0.0069, which (0.05 x 1.16)^2 + 0.0032 = 0.0066 at n = 2 is under.
    constexpr ImageSize kLarge{192, 144};
    auto frames = plant_recovery(
        kLarge.width * kLarge.height / 2, [](int age) { return 1.0 + 2.56 * std::pow(0.25, age); },
        0.05, kLarge);
    for (std::size_t t = 0; t < frames.size(); ++t) {
        add_reference_noise(frames[t], 0.08, 20, static_cast<int>(t));
    }
    const MetricResult result = get_recovery(frames);
    EXPECT_EQ(*result.value, 2.0);
    EXPECT_EQ(*result.debiased, 3.0);
}

} // namespace
} // namespace alcove
