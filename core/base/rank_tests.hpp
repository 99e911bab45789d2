#pragma once
// Tests that ask nothing of the shape of noise: what stands beside Student's t where one wild
// repeat could make a verdict.
//
// This work is based on: Mann, Whitney. On a test of whether one of two random variables is
// stochastically larger than the other. 1947. Wilcoxon. Individual comparisons by ranking methods.
// 1945. Smirnov. On the estimation of the discrepancy between empirical curves of distribution for
// two independent samples. 1939. Hodges. The significance probability of the Smirnov two-sample
// test. 1958 (counting of lattice paths). Schroeer, Trenkler. Exact and randomization distributions
// of Kolmogorov-Smirnov tests two or three samples. 1995 (ties).

#include <cstddef>
#include <span>

namespace alcove {

/// A statistic and how surprising it is if both samples have one distribution; two-sided.
struct RankTest {
    double statistic = 0.0;
    double p_value = 1.0;
    bool is_exact = true; ///< else the normal approximation
};

/// Largest number of values in all for which Mann-Whitney's distribution is counted.
inline constexpr std::size_t kMostExactRanks = 40;

/// U: pairs in which b is larger than a, ties counting half. Exact up to kMostExactRanks values
/// without ties, else normal with the correction for ties and for continuity. The smallest exact
/// p-value is 2 / C(n + m, n): 2/924 for 6 against 6. Asserts one value or more in each.
[[nodiscard]] RankTest test_mann_whitney(std::span<const double> a, std::span<const double> b);

/// D: largest distance between the two empirical distributions, in [0,1]. Exact, also with ties;
/// takes time in proportion to a.size() * b.size(). Asserts one value or more in each.
[[nodiscard]] RankTest test_kolmogorov_smirnov(std::span<const double> a,
                                               std::span<const double> b);

/// Largest number of pairs for which the signed ranks' distribution is counted.
inline constexpr std::size_t kMostExactPairs = 100;

/// W: sum of the ranks of |b[i] - a[i]| where b is larger; equal pairs are left out. Exact, also
/// with ties, up to kMostExactPairs, else normal. The smallest exact p-value is 2 / 2^n: 0.031 for
/// 6 pairs, and 0.0625 for 5. Asserts equal sizes and one pair or more.
[[nodiscard]] RankTest test_signed_ranks(std::span<const double> a, std::span<const double> b);

} // namespace alcove
