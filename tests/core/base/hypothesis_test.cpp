#include "core/base/hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alcove {
namespace {

/// Default repeats of a run (DESIGN 3.6).
constexpr std::size_t kShippedRepeats = 6;

TEST(Hypothesis, PValuesAreThoseOfTheTables) {
    EXPECT_NEAR(compute_student_p_value(2.570582, 5.0), 0.05, 1e-6);
    EXPECT_NEAR(compute_student_p_value(-2.570582, 5.0), 0.05, 1e-6);
    // One degree of freedom is Cauchy's distribution: 2 (1/2 - atan(t) / pi)
    EXPECT_NEAR(compute_student_p_value(1.0, 1.0), 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(compute_student_p_value(0.0, 7.0), 1.0);
}

TEST(Hypothesis, WelchByHand) {
    // means 3 and 8, variances 2.5 and 10, of the means 0.5 and 2: t = 5 / sqrt(2.5) = 3.16228,
    // degrees of freedom 2.5^2 / (0.5^2 / 4 + 2^2 / 4) = 6.25 / 1.0625 = 5.88235
    const std::vector a{1.0, 2.0, 3.0, 4.0, 5.0};
    const std::vector b{4.0, 6.0, 8.0, 10.0, 12.0};
    const MeanTest test = test_independent_means(a, b);
    EXPECT_DOUBLE_EQ(test.difference, 5.0);
    EXPECT_NEAR(test.degrees_of_freedom, 5.88235, 1e-5);
    EXPECT_NEAR(test.p_value, compute_student_p_value(3.16228, 5.88235), 1e-6);
    EXPECT_GT(test.p_value, 0.01);
    EXPECT_LT(test.p_value, 0.05);
    EXPECT_GT(test.interval.lower, 0.0);
    EXPECT_NEAR(test.interval.lower + test.interval.upper, 10.0, 1e-12);
    // the p-value of a difference at the end of its own interval is 5 %
    const double half_width = test.interval.upper - test.difference;
    EXPECT_NEAR(compute_student_p_value(half_width / std::sqrt(2.5), test.degrees_of_freedom), 0.05,
                1e-9);
}

TEST(Hypothesis, GroupsOfEqualSpreadHaveTheDegreesOfStudent) {
    const std::vector a{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
    const std::vector b{2.0, 3.0, 4.0, 5.0, 6.0, 7.0};
    EXPECT_NEAR(test_independent_means(a, b).degrees_of_freedom, 10.0, 1e-9);
}

TEST(Hypothesis, PairsTakeOutWhatTheyShare) {
    // differences 1 2 3 4 5: mean 3, half width 1.96322 (statistics_test)
    const std::vector a{100.0, 200.0, 300.0, 400.0, 500.0};
    const std::vector b{101.0, 202.0, 303.0, 404.0, 505.0};
    const MeanTest test = test_paired_means(a, b);
    EXPECT_DOUBLE_EQ(test.difference, 3.0);
    EXPECT_NEAR(test.interval.lower, 3.0 - 1.96322, 1e-4);
    EXPECT_DOUBLE_EQ(test.degrees_of_freedom, 4.0);
    EXPECT_LT(test.p_value, 0.05);
    EXPECT_GT(test_independent_means(a, b).p_value, 0.9);
}

TEST(Hypothesis, GroupsWithoutSpreadAreEqualOrNot) {
    const std::vector a{2.0, 2.0, 2.0};
    const std::vector b{3.0, 3.0, 3.0};
    EXPECT_EQ(test_independent_means(a, a).p_value, 1.0);
    EXPECT_EQ(test_independent_means(a, b).p_value, 0.0);
    EXPECT_EQ(test_paired_means(a, b).interval.lower, 1.0);
}

TEST(Hypothesis, HolmByHand) {
    // sorted 0.01 0.02 0.03 0.04 times 4 3 2 1 = 0.04 0.06 0.06 0.04, made ascending
    const std::vector<double> adjusted = adjust_holm(std::vector{0.04, 0.01, 0.03, 0.02});
    ASSERT_EQ(adjusted.size(), 4u);
    EXPECT_NEAR(adjusted[1], 0.04, 1e-12);
    EXPECT_NEAR(adjusted[3], 0.06, 1e-12);
    EXPECT_NEAR(adjusted[2], 0.06, 1e-12);
    EXPECT_NEAR(adjusted[0], 0.06, 1e-12);
    EXPECT_EQ(adjust_holm(std::vector{0.6, 0.9}), (std::vector{1.0, 1.0}));
    EXPECT_TRUE(adjust_holm({}).empty());
}

TEST(Hypothesis, BenjaminiHochbergByHand) {
    // sorted 0.01 0.02 0.03 0.04 times 4/1 4/2 4/3 4/4 = 0.04 each; with 0.9: times 5/rank
    for (const double adjusted : adjust_benjamini_hochberg(std::vector{0.04, 0.01, 0.03, 0.02})) {
        EXPECT_NEAR(adjusted, 0.04, 1e-12);
    }
    const std::vector<double> five =
        adjust_benjamini_hochberg(std::vector{0.9, 0.001, 0.03, 0.5, 0.02});
    EXPECT_NEAR(five[1], 0.005, 1e-12);
    EXPECT_NEAR(five[4], 0.05, 1e-12);
    EXPECT_NEAR(five[2], 0.05, 1e-12);
    EXPECT_NEAR(five[3], 0.625, 1e-12);
    EXPECT_NEAR(five[0], 0.9, 1e-12);
    EXPECT_TRUE(adjust_benjamini_hochberg({}).empty());
}

TEST(Hypothesis, AtMostFivePercentOfDiscoveriesAreFalse) {
    // 40 tests, in 10 of them something is there.
    std::mt19937 random(13);
    std::normal_distribution<double> normal;
    double false_share = 0.0;
    double found = 0.0;
    constexpr int kFamilies = 1500;
    for (int f = 0; f < kFamilies; ++f) {
        std::vector<double> p_values;
        for (int t = 0; t < 40; ++t) {
            const double z = normal(random) + (t < 10 ? 3.0 : 0.0);
            p_values.push_back(std::erfc(std::abs(z) / std::sqrt(2.0)));
        }
        const std::vector<double> adjusted = adjust_benjamini_hochberg(p_values);
        const auto count = [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
            return static_cast<double>(std::count_if(adjusted.begin() + begin,
                                                     adjusted.begin() + end,
                                                     [](double p) { return p <= 0.05; }));
        };
        const double wrong = count(10, 40);
        const double right = count(0, 10);
        false_share += wrong + right > 0.0 ? wrong / (wrong + right) : 0.0;
        found += right / 10.0;
    }
    // 30 of 40 are true hypotheses: the rate is 0.05 * 30 / 40
    EXPECT_NEAR(false_share / kFamilies, 0.0375, 0.006);
    EXPECT_GT(found / kFamilies, 0.55);
}

struct Rates {
    double family = 0.0;   ///< families with a false rejection after Holm
    double single = 0.0;   ///< tests that reject without Holm
    double coverage = 0.0; ///< intervals that hold the truth
};

/// Families of eight tests between groups of which nothing differs but the spread.
Rates simulate(int families) {
    constexpr int kTests = 8;
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    Rates rates;
    for (int f = 0; f < families; ++f) {
        std::vector<double> p_values;
        for (int t = 0; t < kTests; ++t) {
            std::vector<double> a;
            std::vector<double> b;
            for (std::size_t i = 0; i < kShippedRepeats; ++i) {
                a.push_back(0.01 * normal(random));
                b.push_back(0.02 * normal(random));
            }
            const MeanTest test = test_independent_means(a, b);
            p_values.push_back(test.p_value);
            rates.single += test.p_value <= 0.05 ? 1.0 : 0.0;
            rates.coverage += test.interval.lower <= 0.0 && test.interval.upper >= 0.0 ? 1.0 : 0.0;
        }
        const std::vector<double> adjusted = adjust_holm(p_values);
        rates.family += *std::min_element(adjusted.begin(), adjusted.end()) <= 0.05 ? 1.0 : 0.0;
    }
    rates.family /= families;
    rates.single /= families * kTests;
    rates.coverage /= families * kTests;
    return rates;
}

TEST(Hypothesis, FalseAlarmsAndCoverageAreAsClaimedAtTheShippedRepeats) {
    // 2000 families of 8: the standard deviation of a 5 % share of families is 0.49 %, of tests
    // 0.17 %; the bounds lie three of them away. Eight independent tests at 5 % would be wrong in
    // 34 % of families.
    const Rates rates = simulate(2000);
    EXPECT_LT(rates.family, 0.05 + 3.0 * 0.0049);
    EXPECT_GT(rates.family, 0.05 - 4.0 * 0.0049);
    EXPECT_NEAR(rates.single, 0.05, 3.0 * 0.0017);
    EXPECT_NEAR(rates.coverage, 0.95, 3.0 * 0.0017);
}

} // namespace
} // namespace alcove
