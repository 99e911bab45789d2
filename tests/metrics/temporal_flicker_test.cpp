// temporal_flicker and flicker_ratio on sequences whose values follow from theory, beyond the
// units' own checks.
#include "core/base/error.hpp"
#include "core/base/statistics.hpp"
#include "tests/metrics/temporal_sequences.hpp"

#include <cmath>

namespace alcove {
namespace {

constexpr ImageSize kSize{96, 72};

std::vector<PlantedFrame> plant_white(PlantedMotion motion, int count, double scale, int use = 1) {
    return plant_errors(kSize, motion, count, scale,
                        [use](int t) { return make_planted_noise(kSize, make_seed(use, t)); });
}

TEST(FlickerRatio, WhiteErrorIsOneHoweverTheSurfaceMoves) {
    for (const PlantedMotion motion : kAllMotions) {
        const std::vector<double> values =
            list_values("flicker_ratio", plant_white(motion, 20, 0.05));
        EXPECT_NEAR(compute_mean(values), 1.0, 0.01) << static_cast<int>(motion);
        for (const double value : values) {
            // One frame of 5000 to 6900 pixels scatters by 0.014.
            EXPECT_NEAR(value, 1.0, 0.06) << static_cast<int>(motion);
        }
    }
}

TEST(FlickerRatio, DriftIsTheRootOfWhatNeighboursDoNotShare) {
    for (const double kept : {0.5, 0.95}) {
        Image error = make_planted_noise(kSize, 0);
        const auto frames = plant_errors(kSize, PlantedMotion::still, 20, 0.1, [&](int t) {
            Image next(kSize, 1);
            add_scaled(next, error, kept);
            add_scaled(next, make_planted_noise(kSize, make_seed(2, t)),
                       std::sqrt(1.0 - kept * kept));
            error = next;
            return error;
        });
        EXPECT_NEAR(compute_mean(list_values("flicker_ratio", frames)), std::sqrt(1.0 - kept), 0.01)
            << kept;
    }
}

TEST(TemporalFlicker, AStaticErrorIsNothingWhereverTheSurfaceGoes) {
    for (const PlantedMotion motion : kAllMotions) {
        const auto frames =
            plant_errors(kSize, motion, 6, 0.1, [](int) { return Image(kSize, 1, 1.0f); });
        for (const double value : list_values("temporal_flicker", frames)) {
            EXPECT_LT(value, 1e-6) << static_cast<int>(motion);
        }
        for (const double value : list_values("flicker_ratio", frames)) {
            EXPECT_LT(value, 1e-5) << static_cast<int>(motion);
        }
    }
}

TEST(TemporalFlicker, ChangeThatTruthMakesTooIsNothing) {
    std::vector<PlantedFrame> frames(6, make_planted_frame(kSize, PlantedMotion::still));
    for (int t = 0; t < 6; ++t) {
        PlantedFrame& frame = frames[static_cast<std::size_t>(t)];
        frame.reference = make_planted_noise(kSize, make_seed(3, t));
        frame.test = frame.reference;
        add_scaled(frame.test, Image(kSize, 1, 1.0f), 0.25);
    }
    for (const double value : list_values("temporal_flicker", frames)) {
        EXPECT_LT(value, 1e-6);
    }
}

TEST(TemporalFlicker, HalfTheErrorHalvesFlickerAndLeavesTheRatio) {
    for (const PlantedMotion motion : kAllMotions) {
        const auto whole = plant_white(motion, 4, 0.1);
        const auto half = plant_white(motion, 4, 0.05);
        const auto flicker = list_values("temporal_flicker", whole);
        const auto half_flicker = list_values("temporal_flicker", half);
        const auto ratio = list_values("flicker_ratio", whole);
        const auto half_ratio = list_values("flicker_ratio", half);
        for (std::size_t t = 0; t < flicker.size(); ++t) {
            EXPECT_NEAR(half_flicker[t], 0.5 * flicker[t], 1e-6);
            EXPECT_NEAR(half_ratio[t], ratio[t], 1e-5);
        }
    }
}

/// Runs a metric on white errors of 0.03 against halves with noise of 0.08, many times.
struct NoisyRun {
    std::vector<double> plain;
    std::vector<double> debiased;
    std::vector<double> floors; ///< where there are any
};

NoisyRun run_noisy(const std::string& name, double scale, PlantedMotion motion) {
    NoisyRun run;
    auto frames = plant_white(motion, 60, scale, 4);
    for (std::size_t t = 0; t < frames.size(); ++t) {
        add_reference_noise(frames[t], 0.08, 5, static_cast<int>(t));
    }
    const auto metric = make_temporal(name);
    for (const auto& result : follow_planted(*metric, frames)) {
        if (result) {
            run.plain.push_back(result->value.value());
            run.debiased.push_back(result->debiased.value());
            if (result->floor) {
                run.floors.push_back(*result->floor);
            }
        }
    }
    return run;
}

double mean_square(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value * value;
    }
    return sum / static_cast<double>(values.size());
}

TEST(TemporalFlicker, DebiasingTakesOutTheReferencesNoise) {
    // Squares: of an error of 0.1 in two frames 2 x 0.1^2, of the mean's noise 2 x 0.08^2 / 2.
    const NoisyRun run = run_noisy("temporal_flicker", 0.1, PlantedMotion::still);
    std::vector<double> squares;
    for (const double value : run.debiased) {
        squares.push_back(value * value);
    }
    const double error =
        compute_standard_deviation(squares) / std::sqrt(static_cast<double>(squares.size()));
    EXPECT_NEAR(compute_mean(squares), 0.02, 3.0 * error);
    EXPECT_LT(error, 0.01 * 0.02) << "too few draws to say";
    EXPECT_NEAR(mean_square(run.floors), 0.0064, 0.0001);
    EXPECT_NEAR(mean_square(run.plain), 0.0264, 0.0003);
}

TEST(TemporalFlicker, TruthItselfIsUnderTheFloor) {
    const NoisyRun run = run_noisy("temporal_flicker", 0.0, PlantedMotion::still);
    EXPECT_NEAR(mean_square(run.plain), 0.0064, 0.0001);
    for (std::size_t t = 0; t < run.debiased.size(); ++t) {
        EXPECT_LT(run.debiased[t], 0.3 * run.floors[t]);
    }
}

TEST(FlickerRatio, DebiasingFindsTheErrorThatSticksUnderNoise) {
    // An error of 0.1 that sticks: the noise alone makes the plain ratio
    // sqrt(0.0064 / (0.02 + 0.0064)).
    auto frames = plant_errors(kSize, PlantedMotion::still, 30, 0.1,
                               [](int) { return make_planted_noise(kSize, 7); });
    for (std::size_t t = 0; t < frames.size(); ++t) {
        add_reference_noise(frames[t], 0.08, 6, static_cast<int>(t));
    }
    const auto metric = make_temporal("flicker_ratio");
    double debiased = 0.0;
    double plain = 0.0;
    const auto results = follow_planted(*metric, frames);
    for (std::size_t t = 1; t < results.size(); ++t) {
        plain += *results[t]->value * *results[t]->value / 29.0;
        debiased += *results[t]->debiased * *results[t]->debiased / 29.0;
    }
    EXPECT_NEAR(plain, 0.0064 / 0.0264, 0.005);
    EXPECT_LT(debiased, 0.005);
}

TEST(FlickerRatio, IsUndefinedWithoutAnErrorAboveTheFloor) {
    const auto metric = make_temporal("flicker_ratio");
    std::vector<PlantedFrame> frames(3, make_planted_frame(kSize, PlantedMotion::still));
    EXPECT_FALSE(follow_planted(*metric, frames).back()->value.has_value());
    EXPECT_NE(follow_planted(*metric, frames).back()->undefined_reason.find("no error"),
              std::string::npos);
    for (std::size_t t = 0; t < frames.size(); ++t) {
        add_reference_noise(frames[t], 0.08, 8, static_cast<int>(t));
    }
    const std::optional<MetricResult> noise = follow_planted(*metric, frames).back();
    EXPECT_FALSE(noise->value.has_value());
    EXPECT_NE(noise->undefined_reason.find("floor"), std::string::npos);
}

TEST(TemporalFlicker, BackgroundAndHiddenPixelsCountNothing) {
    auto frames = plant_white(PlantedMotion::still, 2, 0.0);
    PlantedFrame& last = frames.back();
    last.test.at(3, 4) = 100.0f;
    last.surface.at(3, 4) = 0.0f;
    last.test.at(5, 6) = 100.0f;
    last.to_previous.valid.at(5, 6) = 0.0f;
    last.test.at(7, 8) += 0.2f;
    const auto metric = make_temporal("temporal_flicker");
    const MetricResult result = follow_planted(*metric, frames).back().value();
    EXPECT_NEAR(*result.value, 0.2 / std::sqrt(static_cast<double>(kSize.pixel_count() - 2)), 1e-8);
    EXPECT_EQ(result.map->at(3, 4), 0.0f);
    EXPECT_EQ(result.map->at(5, 6), 0.0f);
    EXPECT_NEAR(result.map->at(7, 8), 0.2f, 1e-6f);
    last.surface = Image(kSize, 1);
    for (const char* name : {"temporal_flicker", "flicker_ratio"}) {
        const auto empty = make_temporal(name);
        const MetricResult none = follow_planted(*empty, frames).back().value();
        EXPECT_FALSE(none.value.has_value()) << name;
        EXPECT_FALSE(none.undefined_reason.empty()) << name;
    }
}

} // namespace
} // namespace alcove
