#include "core/base/rank_tests.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace alcove {
namespace {

/// Orders of six and six: C(12, 6).
constexpr double kOrders = 924.0;

/// 'a' and 'b' stand for values that ascend, each of its group.
struct Groups {
    std::vector<double> a;
    std::vector<double> b;
};

Groups place(const std::string& order) {
    Groups groups;
    for (std::size_t i = 0; i < order.size(); ++i) {
        (order[i] == 'a' ? groups.a : groups.b).push_back(static_cast<double>(i));
    }
    return groups;
}

RankTest test_u(const std::string& order) {
    const Groups groups = place(order);
    return test_mann_whitney(groups.a, groups.b);
}

RankTest test_d(const std::string& order) {
    const Groups groups = place(order);
    return test_kolmogorov_smirnov(groups.a, groups.b);
}

TEST(MannWhitney, SmallGroupsAreCounted) {
    // the smallest p-value of six against six
    EXPECT_NEAR(test_u("aaaaaabbbbbb").p_value, 2.0 / kOrders, 1e-12);
    EXPECT_EQ(test_u("aaaaaabbbbbb").statistic, 36.0);
    EXPECT_NEAR(test_u("bbbbbbaaaaaa").p_value, 2.0 / kOrders, 1e-12);
    EXPECT_EQ(test_u("bbbbbbaaaaaa").statistic, 0.0);
    // U of three against three: 1 1 2 3 3 3 3 2 1 1 of 20; here 6
    EXPECT_EQ(test_u("ababab").statistic, 6.0);
    EXPECT_NEAR(test_u("ababab").p_value, 14.0 / 20.0, 1e-12);
    EXPECT_NEAR(test_u("aaabbb").p_value, 2.0 / 20.0, 1e-12);
    // 2 against 4, U = 7 of 8: 15 orders, U >= 7 in two of them
    EXPECT_NEAR(test_u("abbabb").p_value, 2.0 * 4.0 / 15.0, 1e-12); // U = 6: 1 + 1 + 2 orders
    EXPECT_TRUE(test_u("aaaaaabbbbbb").is_exact);
}

TEST(MannWhitney, TiesAreTakenFromTheVariance) {
    // U = 2 + 3 + 3, variance 9/12 (7 - 24/30) = 4.65, z = (8 - 4.5 - 0.5) / 2.15639 = 1.39122
    const RankTest test = test_mann_whitney(std::vector{1.0, 2.0, 2.0}, std::vector{2.0, 3.0, 4.0});
    EXPECT_EQ(test.statistic, 8.0);
    EXPECT_FALSE(test.is_exact);
    EXPECT_NEAR(test.p_value, 0.16416, 1e-4);
    const std::vector same(6, 1.0);
    EXPECT_EQ(test_mann_whitney(same, same).p_value, 1.0);
}

TEST(MannWhitney, CountingAndTheNormalAgreeWhereOneTakesOver) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 20; ++i) {
        std::vector<double> a(20);
        std::vector<double> b(20);
        for (std::size_t k = 0; k < 20; ++k) {
            a[k] = normal(random);
            b[k] = normal(random) + 0.5;
        }
        const double exact = test_mann_whitney(a, b).p_value;
        b.push_back(0.0); // one more than is counted
        const RankTest more = test_mann_whitney(a, b);
        EXPECT_FALSE(more.is_exact);
        EXPECT_NEAR(more.p_value, exact, 0.12);
        b.back() = b.front(); // ties do the same
        b.resize(20);
        b.back() = b.front();
        EXPECT_FALSE(test_mann_whitney(a, b).is_exact);
    }
}

TEST(KolmogorovSmirnov, SmallGroupsAreCounted) {
    // P(D >= k/n) = 2 (C(2n, n-k) - C(2n, n-2k) + ...) / C(2n, n) for n against n
    EXPECT_NEAR(test_d("aaaaaabbbbbb").p_value, 2.0 / kOrders, 1e-12);
    EXPECT_NEAR(test_d("aaaaababbbbb").p_value, 2.0 * 12.0 / kOrders, 1e-12);
    EXPECT_NEAR(test_d("aaabbbaaabbb").p_value, 2.0 * (220.0 - 1.0) / kOrders, 1e-12);
    EXPECT_NEAR(test_d("aaabbbaaabbb").statistic, 0.5, 1e-12);
    EXPECT_NEAR(test_d("ababab").p_value, 1.0, 1e-12);
    EXPECT_NEAR(test_d("bbbaaa").p_value, 2.0 / 20.0, 1e-12);
    // one against three: D = 1 in two of four orders
    EXPECT_NEAR(test_d("abbb").p_value, 0.5, 1e-12);
}

TEST(KolmogorovSmirnov, DistancesInsideARunOfTiesDoNotCount) {
    // after the three ones D = |2/3 - 1/3|, and any order has at least that there
    EXPECT_NEAR(
        test_kolmogorov_smirnov(std::vector{1.0, 1.0, 2.0}, std::vector{1.0, 2.0, 2.0}).statistic,
        1.0 / 3.0, 1e-12);
    EXPECT_NEAR(
        test_kolmogorov_smirnov(std::vector{1.0, 1.0, 2.0}, std::vector{1.0, 2.0, 2.0}).p_value,
        1.0, 1e-12);
    const std::vector ones(3, 1.0);
    const std::vector twos(3, 2.0);
    EXPECT_NEAR(test_kolmogorov_smirnov(ones, twos).p_value, 2.0 / 20.0, 1e-12);
    EXPECT_EQ(test_kolmogorov_smirnov(ones, ones).p_value, 1.0);
}

TEST(KolmogorovSmirnov, SeesAnotherSpreadWhereRanksSeeNone) {
    // the b lie outside of the a on both sides
    EXPECT_NEAR(test_u("bbbbbbaaaaaaaaaaaabbbbbb").p_value, 1.0, 1e-12);
    EXPECT_LT(test_d("bbbbbbaaaaaaaaaaaabbbbbb").p_value, 0.11);
}

RankTest test_w(const std::vector<double>& differences) {
    return test_signed_ranks(std::vector<double>(differences.size(), 0.0), differences);
}

TEST(SignedRanks, SmallGroupsAreCounted) {
    EXPECT_NEAR(test_w({1, 2, 3, 4, 5, 6}).p_value, 2.0 / 64.0, 1e-12);
    EXPECT_NEAR(test_w({-1, -2, -3, -4, -5}).p_value, 2.0 / 32.0, 1e-12);
    EXPECT_NEAR(test_w({-1, 2, 3, 4, 5}).p_value, 4.0 / 32.0, 1e-12);
    EXPECT_EQ(test_w({-1, 2, 3, 4, 5}).statistic, 14.0);
    EXPECT_EQ(test_w({1, 2, -3}).p_value, 1.0);
    EXPECT_EQ(test_w({0, 0}).p_value, 1.0);
    EXPECT_NEAR(test_w({0, 1, 2, 3}).p_value, 2.0 / 8.0, 1e-12);
    // ranks 1.5 1.5 3, W = 4.5: of the eight sums 0 1.5 1.5 3 3 4.5 4.5 6 three are as large
    EXPECT_NEAR(test_w({-1, 1, 2}).p_value, 6.0 / 8.0, 1e-12);
}

TEST(SignedRanks, CountingAndTheNormalAgreeWhereOneTakesOver) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    std::vector<double> differences(kMostExactPairs);
    for (double& difference : differences) {
        difference = normal(random) + 0.15;
    }
    const RankTest exact = test_w(differences);
    differences.push_back(1e-9);
    const RankTest more = test_w(differences);
    EXPECT_TRUE(exact.is_exact);
    EXPECT_FALSE(more.is_exact);
    EXPECT_NEAR(more.p_value, exact.p_value, 0.02);
}

TEST(RankTests, FalseAlarmsStayUnderFivePercentWhateverTheShape) {
    std::mt19937 random(17);
    std::normal_distribution<double> normal;
    constexpr int kTrials = 4000;
    int u = 0;
    int d = 0;
    int w = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<double> a(6);
        std::vector<double> b(6);
        for (std::size_t i = 0; i < 6; ++i) {
            a[i] = std::exp(2.0 * normal(random));
            b[i] = std::exp(2.0 * normal(random));
        }
        u += test_mann_whitney(a, b).p_value <= 0.05 ? 1 : 0;
        d += test_kolmogorov_smirnov(a, b).p_value <= 0.05 ? 1 : 0;
        w += test_signed_ranks(a, b).p_value <= 0.05 ? 1 : 0;
    }
    // The attainable levels below 5 %: 38/924 = 4.1 %, 24/924 = 2.6 %, 2/64 = 3.1 %; 3 sigma.
    EXPECT_NEAR(u / static_cast<double>(kTrials), 38.0 / kOrders, 0.0095);
    EXPECT_NEAR(d / static_cast<double>(kTrials), 24.0 / kOrders, 0.0076);
    EXPECT_NEAR(w / static_cast<double>(kTrials), 2.0 / 64.0, 0.0083);
}

} // namespace
} // namespace alcove
