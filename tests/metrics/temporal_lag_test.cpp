// lag_frames and lag_share on sequences that mix an older truth into the test image.
#include "tests/metrics/temporal_sequences.hpp"

#include <cmath>

namespace alcove {
namespace {

constexpr ImageSize kSize{96, 72};

/// A truth that swings differently in each pixel, fixed to the surface, and a test image that is
/// `share` the truth `steps` frames ago, for motions of whole pixels.
std::vector<PlantedFrame> plant_lag(PlantedMotion motion, double share, int steps) {
    std::vector<PlantedFrame> frames(14, make_planted_frame(kSize, motion));
    const auto shade = [&](int x, int y, int seen_in, int time) {
        const PlantedPoint point = find_planted_point(kSize, motion, seen_in, x, y);
        return 0.5 + 0.2 * std::sin(0.4 * point.x + (0.2 + 0.01 * point.y) * time);
    };
    for (int t = 0; t < 14; ++t) {
        PlantedFrame& frame = frames[static_cast<std::size_t>(t)];
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                frame.reference.at(x, y) = static_cast<float>(shade(x, y, t, t));
                frame.test.at(x, y) = static_cast<float>((1.0 - share) * shade(x, y, t, t) +
                                                         share * shade(x, y, t, t - steps));
            }
        }
    }
    return frames;
}

MetricResult get_last(const std::string& name, const std::vector<PlantedFrame>& frames) {
    const auto metric = make_temporal(name);
    return follow_planted(*metric, frames).back().value();
}

TEST(Lag, FindsEachStepAndShareStillAndPanning) {
    for (const PlantedMotion motion : {PlantedMotion::still, PlantedMotion::pan_one_pixel}) {
        for (const int steps : kEarlierSteps) {
            for (const double share : {0.1, 0.4, 0.9}) {
                const auto frames = plant_lag(motion, share, steps);
                EXPECT_EQ(*get_last("lag_frames", frames).value, steps) << share;
                EXPECT_NEAR(*get_last("lag_share", frames).value, share, 1e-4) << steps;
            }
        }
    }
}

TEST(Lag, AShareThatIsLittleIsNoLagButIsTold) {
    const auto frames = plant_lag(PlantedMotion::still, 0.03, 2);
    EXPECT_EQ(*get_last("lag_frames", frames).value, 0.0);
    EXPECT_NEAR(*get_last("lag_share", frames).value, 0.03, 1e-4);
    const auto ahead = plant_lag(PlantedMotion::still, -0.3, 2);
    EXPECT_EQ(*get_last("lag_frames", ahead).value, 0.0);
    EXPECT_NEAR(*get_last("lag_share", ahead).value, -0.3, 1e-4);
}

TEST(Lag, DebiasingTakesOutWhatNoiseInTruthDoesToTheShare) {
    // Truth and its noise are alike here: the noise that x and y share pulls the plain share up.
    double plain = 0.0;
    double debiased = 0.0;
    constexpr int kDraws = 12;
    for (int draw = 0; draw < kDraws; ++draw) {
        auto frames = plant_lag(PlantedMotion::still, 0.3, 4);
        for (std::size_t t = 0; t < frames.size(); ++t) {
            add_reference_noise(frames[t], 0.05, 10 + draw, static_cast<int>(t));
        }
        const MetricResult share = get_last("lag_share", frames);
        plain += *share.value / kDraws;
        debiased += *share.debiased / kDraws;
        EXPECT_EQ(*get_last("lag_frames", frames).debiased, 4.0);
    }
    EXPECT_NEAR(debiased, 0.3, 0.005);
    EXPECT_GT(std::abs(plain - 0.3), 2.0 * std::abs(debiased - 0.3));
}

TEST(Lag, HasNoResultBeforeItSeesAllStepsAndNoValueWhereTruthStands) {
    const auto metric = make_temporal("lag_share");
    auto frames = plant_lag(PlantedMotion::still, 0.4, 4);
    const auto results = follow_planted(*metric, frames);
    for (std::size_t t = 0; t < results.size(); ++t) {
        EXPECT_EQ(results[t].has_value(), t >= 8) << t;
    }
    const std::vector<PlantedFrame> standing(10, make_planted_frame(kSize, PlantedMotion::still));
    const MetricResult none = get_last("lag_share", standing);
    EXPECT_FALSE(none.value.has_value());
    EXPECT_NE(none.undefined_reason.find("64 are needed"), std::string::npos)
        << none.undefined_reason;
}

} // namespace
} // namespace alcove
