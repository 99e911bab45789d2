#include "core/base/spread.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace alcove {
namespace {

TEST(Outliers, FencesByHand) {
    // quartiles 2 and 4: mild above 7 or below -1, severe above 10 or below -4
    const auto count = [](double last) {
        return *classify_outliers(std::vector{1.0, 2.0, 3.0, 4.0, last});
    };
    EXPECT_FALSE(count(7.0).any());
    EXPECT_EQ(count(7.1).mild, 1u);
    EXPECT_EQ(count(10.0).severe, 0u);
    EXPECT_EQ(count(10.1).severe, 1u);
    EXPECT_EQ(count(10.1).mild, 0u);
    EXPECT_EQ(count(10.1).n, 5u);
    EXPECT_EQ(classify_outliers(std::vector{-9.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.1})->severe, 2u);
}

TEST(Outliers, QuartilesOfFourSayNothing) {
    EXPECT_FALSE(classify_outliers(std::vector{1.0, 1.0, 1.0, 100.0}));
}

TEST(Memory, AutocorrelationByHand) {
    // deviations -2 -1 0 1 2: 2 + 0 + 0 + 2 over 10
    EXPECT_NEAR(*compute_lag1_autocorrelation(std::vector{1.0, 2.0, 3.0, 4.0, 5.0}), 0.4, 1e-12);
    EXPECT_NEAR(*compute_lag1_autocorrelation(std::vector{1.0, -1.0, 1.0, -1.0, 1.0, -1.0}),
                -5.0 / 6.0, 1e-12);
    EXPECT_FALSE(compute_lag1_autocorrelation(std::vector<double>(6, 2.0)));
    EXPECT_FALSE(compute_lag1_autocorrelation(std::vector{1.0, 2.0, 3.0, 4.0}));
}

/// Share of series whose memory is seen.
double find_detected(double memory, std::size_t n) {
    constexpr int kTrials = 3000;
    std::mt19937 random(23);
    std::normal_distribution<double> normal;
    int seen = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<double> values;
        double state = normal(random) / std::sqrt(1.0 - memory * memory);
        for (std::size_t i = 0; i < n; ++i) {
            values.push_back(state);
            state = memory * state + normal(random);
        }
        seen += *compute_lag1_autocorrelation(values) > compute_lag1_bound(n) ? 1 : 0;
    }
    return static_cast<double>(seen) / kTrials;
}

TEST(Memory, IsSeenInManyRepeatsAndHardlyInSix) {
    EXPECT_NEAR(compute_lag1_bound(6), 0.458, 1e-3);
    for (const std::size_t n : {6u, 12u, 24u, 48u}) {
        EXPECT_LT(find_detected(0.0, n), 0.06) << n; // what is not there is seldom seen
    }
    // reports/README.md has these
    EXPECT_NEAR(find_detected(0.6, 6), 0.09, 0.02);
    EXPECT_NEAR(find_detected(0.6, 12), 0.43, 0.03);
    EXPECT_NEAR(find_detected(0.6, 24), 0.82, 0.025);
    EXPECT_NEAR(find_detected(0.3, 24), 0.35, 0.03);
    EXPECT_GT(find_detected(0.6, 48), 0.97);
}

TEST(SlowFrames, TwoOfTwoHundred) {
    std::vector<double> times(198, 1.0);
    times.push_back(20.0);
    times.push_back(10.0);
    const SlowFrames slow = compute_slow_frames(times);
    EXPECT_DOUBLE_EQ(slow.slowest_mean, 15.0);
    EXPECT_DOUBLE_EQ(slow.time_integral, 20.0); // more than 1 % of 228 at once
}

TEST(SlowFrames, TheTimeIntegralGoesOnUntilOnePercentOfTheTimeIsTaken) {
    // total 1002, 1 % of it 10.02: 3 and eight ones, the last of which is 1
    std::vector<double> times(999, 1.0);
    times.push_back(3.0);
    const SlowFrames slow = compute_slow_frames(times);
    EXPECT_DOUBLE_EQ(slow.time_integral, 1.0);
    EXPECT_DOUBLE_EQ(slow.slowest_mean, 1.2); // 3 and nine ones
    // a frame of 4 and one of 3 have taken 7 of 10.05 when a frame of 2 is next, then ones
    times.assign(996, 1.0);
    times.insert(times.end(), {4.0, 3.0, 2.0});
    EXPECT_DOUBLE_EQ(compute_slow_frames(times).time_integral, 1.0);
    times.insert(times.end(), {4.0});
    EXPECT_DOUBLE_EQ(compute_slow_frames(times).time_integral, 3.0); // 4 + 4 + 3 of 10.09
}

TEST(SlowFrames, OfFewFramesItIsTheSlowest) {
    const SlowFrames slow = compute_slow_frames(std::vector{2.0, 5.0, 3.0});
    EXPECT_EQ(slow.slowest_mean, 5.0);
    EXPECT_EQ(slow.time_integral, 5.0);
}

} // namespace
} // namespace alcove
