#include "core/base/statistics.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace alcove {
namespace {

/// Default repeats of a run (DESIGN 3.6).
constexpr std::size_t kShippedRepeats = 6;

TEST(Statistics, MedianAndQuantilesByHand) {
    EXPECT_DOUBLE_EQ(compute_median(std::vector{3.0, 1.0, 2.0}), 2.0);
    EXPECT_DOUBLE_EQ(compute_median(std::vector{4.0, 1.0, 2.0, 3.0}), 2.5);
    const std::vector values{10.0, 20.0, 30.0, 40.0, 50.0};
    EXPECT_DOUBLE_EQ(compute_quantile(values, 0.25), 20.0);
    EXPECT_DOUBLE_EQ(compute_quantile(values, 0.9), 46.0);
    EXPECT_DOUBLE_EQ(compute_quantile(values, 0.0), 10.0);
    EXPECT_DOUBLE_EQ(compute_quantile(values, 1.0), 50.0);
}

TEST(Statistics, SpreadByHand) {
    // mean 5, squared deviations 9 1 1 1 0 0 4 16 = 32, over n - 1 = 7
    const std::vector values{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};
    EXPECT_DOUBLE_EQ(compute_mean(values), 5.0);
    EXPECT_NEAR(compute_standard_deviation(values), std::sqrt(32.0 / 7.0), 1e-12);
}

TEST(Statistics, StudentQuantilesAreThoseOfTheTables) {
    EXPECT_NEAR(compute_student_t95(1), 12.7062, 5e-5);
    EXPECT_NEAR(compute_student_t95(4), 2.7764, 5e-5);
    EXPECT_NEAR(compute_student_t95(5), 2.5706, 5e-5);
    EXPECT_NEAR(compute_student_t95(30), 2.0423, 5e-5);
}

TEST(Statistics, IntervalOfFiveByHand) {
    // mean 3, sd sqrt(2.5), t(4) 2.7764: half width 2.7764 sqrt(2.5 / 5) = 1.96322
    const Estimate estimate = estimate_across_repeats(std::vector{1.0, 2.0, 3.0, 4.0, 5.0});
    ASSERT_TRUE(estimate.interval);
    EXPECT_NEAR(estimate.interval->lower, 3.0 - 1.96322, 1e-4);
    EXPECT_NEAR(estimate.interval->upper, 3.0 + 1.96322, 1e-4);
}

TEST(Statistics, UnderFiveRepeatsThereIsNoInterval) {
    const Estimate estimate = estimate_across_repeats(std::vector{1.0, 2.0, 3.0, 4.0});
    EXPECT_FALSE(estimate.interval);
    EXPECT_EQ(estimate.minimum, 1.0);
    EXPECT_EQ(estimate.maximum, 4.0);
    EXPECT_EQ(estimate.n, 4u);
}

TEST(Statistics, PairedRatioTakesTheMedianOverFramesFirst) {
    // ratios 2, 2, 100 in one repeat: the outlying frame does not move it
    const RepeatsByFrames a{{2.0, 4.0, 300.0}, {4.0, 8.0, 12.0}};
    const RepeatsByFrames b{{1.0, 2.0, 3.0}, {2.0, 4.0, 6.0}};
    const std::optional<Estimate> ratio = estimate_paired_ratio(a, b);
    ASSERT_TRUE(ratio);
    EXPECT_NEAR(ratio->value, 2.0, 1e-12);
    EXPECT_EQ(ratio->n, 2u);
}

TEST(Statistics, FramesWithoutASampleAreLeftOut) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::optional<Estimate> ratio =
        estimate_paired_ratio({{none, 6.0}, {none, none}}, {{1.0, 2.0}, {1.0, 1.0}});
    ASSERT_TRUE(ratio);
    EXPECT_NEAR(ratio->value, 3.0, 1e-12);
    EXPECT_EQ(ratio->n, 1u);
    EXPECT_FALSE(estimate_paired_ratio({{none}}, {{1.0}}));
}

TEST(Statistics, DetectableEffectIsTheFartherEndOfTheInterval) {
    Estimate aa;
    aa.value = 1.01;
    aa.interval = Interval{0.97, 1.05};
    EXPECT_NEAR(compute_minimum_detectable_effect(aa), 0.05, 1e-12);
}

/// Share of simulated experiments whose interval holds the truth. Frames share their repeat's error
/// (what makes the repeat the unit of inference), and both sides share a drift (what pairing takes
/// out).
double simulate_coverage(std::size_t repeats, int experiments) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    constexpr double kTrueRatio = 1.7;
    int covered = 0;
    for (int e = 0; e < experiments; ++e) {
        RepeatsByFrames a;
        RepeatsByFrames b;
        for (std::size_t r = 0; r < repeats; ++r) {
            const double repeat_error = 0.03 * normal(random);
            double drift = 0.0;
            std::vector<double> row_a;
            std::vector<double> row_b;
            for (int frame = 0; frame < 40; ++frame) {
                drift = 0.9 * drift + 0.05 * normal(random);
                const double content = 10.0 + 3.0 * std::sin(0.3 * frame);
                row_b.push_back(content * std::exp(drift + 0.02 * normal(random)));
                row_a.push_back(kTrueRatio * content *
                                std::exp(drift + repeat_error + 0.02 * normal(random)));
            }
            a.push_back(row_a);
            b.push_back(row_b);
        }
        const std::optional<Estimate> ratio = estimate_paired_ratio(a, b);
        covered += ratio && ratio->interval && ratio->interval->lower <= kTrueRatio &&
                           kTrueRatio <= ratio->interval->upper
                       ? 1
                       : 0;
    }
    return static_cast<double>(covered) / experiments;
}

TEST(Statistics, IntervalsCoverTheTruthAsOftenAsTheyClaimAtTheShippedRepeats) {
    // 2000 experiments: the share's own standard deviation is 0.49 %, the bounds lie three of them
    // from 95 %.
    const double coverage = simulate_coverage(kShippedRepeats, 2000);
    EXPECT_GT(coverage, 0.935);
    EXPECT_LT(coverage, 0.965);
}

} // namespace
} // namespace alcove
