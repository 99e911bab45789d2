// trail_energy on truths that brighten at known points.
#include "tests/metrics/temporal_sequences.hpp"

#include <cmath>

namespace alcove {
namespace {

constexpr ImageSize kSize{40, 30};

MetricResult get_trail(const std::vector<PlantedFrame>& frames,
                       const std::vector<ParameterOverride>& overrides = {}) {
    return follow_planted(*make_temporal("trail_energy", overrides), frames).back().value();
}

void expect_nothing_brightens(const MetricResult& result) {
    EXPECT_FALSE(result.value.has_value());
    EXPECT_NE(result.undefined_reason.find("brightens at no point"), std::string::npos)
        << result.undefined_reason;
}

/// Two frames; in the second, column x differs by `rise` in truth and by `error` in the test.
std::vector<PlantedFrame> plant_column(std::vector<PlantedFrame> frames, int x, double rise,
                                       double error) {
    for (int y = 0; y < kSize.height; ++y) {
        frames.back().reference.at(x, y) += static_cast<float>(rise);
        frames.back().test.at(x, y) = frames.back().reference.at(x, y) + static_cast<float>(error);
    }
    return frames;
}

std::vector<PlantedFrame> make_two_frames() {
    return std::vector<PlantedFrame>(2, make_planted_frame(kSize, PlantedMotion::still));
}

TEST(TrailEnergy, IsTheErrorWhereTruthHasBrightenedAndNowhereElse) {
    auto frames = make_two_frames();
    frames = plant_column(frames, 0, 0.3, -0.3); // the trail
    frames = plant_column(frames, 1, 0.2, 0.1);  // overshoot counts alike
    frames = plant_column(frames, 2, 0.0, 9.0);  // truth stays
    frames = plant_column(frames, 3, -0.3, 9.0); // truth darkens
    frames = plant_column(frames, 4, 0.04, 9.0); // by less than `change`
    frames = plant_column(frames, 5, 0.3, 9.0);  // hidden before
    frames = plant_column(frames, 6, 0.3, 9.0);  // the object moves
    frames = plant_column(frames, 7, 0.3, 9.0);  // background
    for (int y = 0; y < kSize.height; ++y) {
        frames.back().to_previous.valid.at(5, y) = 0.0f;
        frames.back().moves.at(6, y) = 1.0f;
        frames.back().surface.at(7, y) = 0.0f;
    }
    const MetricResult result = get_trail(frames);
    EXPECT_NEAR(*result.value, std::sqrt((0.09 + 0.01) / 2.0), 1e-6);
    EXPECT_FALSE(result.debiased || result.floor) << "the reference has no halves";
    for (int x = 0; x < kSize.width; ++x) {
        EXPECT_NEAR(result.map->at(x, 3), x == 0 ? 0.3 : x == 1 ? 0.1 : 0.0, 1e-6) << x;
    }
    EXPECT_NEAR(*get_trail(frames, {{"change", "0.25"}}).value, 0.3, 1e-6);
}

TEST(TrailEnergy, ReachesEightFramesBackAndNoFurther) {
    constexpr std::size_t kBrightens = 5;
    std::vector<PlantedFrame> frames(16, make_planted_frame(kSize, PlantedMotion::still));
    for (std::size_t t = kBrightens; t < frames.size(); ++t) {
        add_scaled(frames[t].reference, Image(kSize, 1, 1.0f), 0.2);
    }
    const auto metric = make_temporal("trail_energy");
    const auto results = follow_planted(*metric, frames);
    EXPECT_FALSE(results.front().has_value()) << "a first frame";
    for (std::size_t t = 1; t < frames.size(); ++t) {
        if (t >= kBrightens && t < kBrightens + 8) {
            EXPECT_NEAR(results[t]->value.value(), 0.2, 1e-6) << t;
        } else {
            expect_nothing_brightens(results[t].value());
        }
    }
}

TEST(TrailEnergy, TruthThatMovesWithItsSurfaceDoesNotBrighten) {
    std::vector<PlantedFrame> frames(10, make_planted_frame(kSize, PlantedMotion::pan_one_pixel));
    for (std::size_t t = 0; t < frames.size(); ++t) {
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                const PlantedPoint point = find_planted_point(kSize, PlantedMotion::pan_one_pixel,
                                                              static_cast<int>(t), x, y);
                frames[t].reference.at(x, y) =
                    static_cast<float>(0.5 + 0.4 * std::sin(1.3 * point.x));
            }
        }
    }
    expect_nothing_brightens(get_trail(frames));
}

TEST(TrailEnergy, DebiasingTakesOutTheReferencesNoise) {
    // The test shows the truth before it brightened by 0.4: the mean's noise adds 0.1^2 / 2.
    constexpr ImageSize kLarge{192, 144};
    std::vector<PlantedFrame> frames(2, make_planted_frame(kLarge, PlantedMotion::still));
    add_scaled(frames[1].reference, Image(kLarge, 1, 1.0f), 0.4);
    for (int t = 0; t < 2; ++t) {
        add_reference_noise(frames[static_cast<std::size_t>(t)], 0.05, 30, t);
    }
    const MetricResult result = get_trail(frames);
    // 4 standard errors of 27648 pixels: the square of the debiased scatters by
    // sqrt(2 x 0.4^2 x 0.05^2 + 0.05^4), a square x by 2 x 0.4 x its root.
    const double scatter =
        4.0 * std::sqrt((2.0 * 0.16 * 0.0025 + 0.00000625) / 27648.0) / (2.0 * 0.4);
    EXPECT_NEAR(*result.debiased, 0.4, scatter);
    EXPECT_NEAR(*result.floor, 0.05 / std::sqrt(2.0), 0.001);
    EXPECT_NEAR(*result.value, std::sqrt(0.16 + 0.00125), scatter);
}

TEST(TrailEnergy, NoiseOfTheReferenceDoesNotChooseThePixels) {
    // Noise that never exceeds twice its root of 3: two means differ by less than four standard
    // deviations, though by far more than `change`.
    std::vector<PlantedFrame> frames(10, make_planted_frame(kSize, PlantedMotion::still));
    for (std::size_t t = 0; t < frames.size(); ++t) {
        add_reference_noise(frames[t], 0.1, 31, static_cast<int>(t));
    }
    expect_nothing_brightens(get_trail(frames));
    // A rise well above is seen through it.
    add_scaled(frames.back().reference, Image(kSize, 1, 1.0f), 0.8);
    EXPECT_TRUE(get_trail(frames).value.has_value());
}

} // namespace
} // namespace alcove
