#include "core/base/rank_tests.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include <boost/math/distributions/normal.hpp>

namespace alcove {
namespace {

/// A value and whether it is of the second group.
using Labelled = std::pair<double, bool>;

std::vector<Labelled> sort_together(std::span<const double> a, std::span<const double> b) {
    std::vector<Labelled> values;
    for (const double value : a) {
        values.emplace_back(value, false);
    }
    for (const double value : b) {
        values.emplace_back(value, true);
    }
    std::sort(values.begin(), values.end());
    return values;
}

/// Twice the ranks, so that the mean ranks of ties are whole, and what ties take from the variance.
struct Ranks {
    std::vector<std::size_t> doubled; ///< of ascending values
    double tied_cubes = 0.0;          ///< sum of t^3 - t over groups of t equal values
};

template <class Value, class Get>
Ranks rank_sorted(const std::vector<Value>& sorted, const Get& get) {
    Ranks ranks;
    for (std::size_t begin = 0; begin < sorted.size();) {
        std::size_t end = begin + 1;
        while (end < sorted.size() && get(sorted[end]) == get(sorted[begin])) {
            ++end;
        }
        ranks.doubled.insert(ranks.doubled.end(), end - begin, begin + end + 1);
        const auto tied = static_cast<double>(end - begin);
        ranks.tied_cubes += tied * tied * tied - tied;
        begin = end;
    }
    return ranks;
}

double compute_normal_p_value(double distance, double variance) {
    if (variance <= 0.0) {
        return 1.0;
    }
    constexpr double kContinuity = 0.5;
    const double z = std::max(0.0, std::abs(distance) - kContinuity) / std::sqrt(variance);
    return std::min(1.0, 2.0 * boost::math::cdf(boost::math::complement(
                                   boost::math::normal_distribution<double>(), z)));
}

/// Two-sided p-value of `value` in a distribution over 0, 1, 2, ... that is symmetric.
double sum_both_tails(const std::vector<double>& shares, std::size_t value) {
    double tail = 0.0;
    for (std::size_t i = 0; i <= std::min(value, shares.size() - 1 - value); ++i) {
        tail += shares[i];
    }
    return std::min(1.0, 2.0 * tail);
}

/// Shares of the arrangements of n and m values that have U = 0, 1, ..., n m: the coefficients of
/// the Gaussian binomial, a product over i = 1..n of (1 - q^(m + i)) / (1 - q^i).
std::vector<double> count_mann_whitney(std::size_t n, std::size_t m) {
    std::vector<double> counts(n * m + 1, 0.0);
    counts[0] = 1.0;
    for (std::size_t i = 1; i <= n; ++i) {
        for (std::size_t u = counts.size(); u-- > m + i;) {
            counts[u] -= counts[u - (m + i)];
        }
        for (std::size_t u = i; u < counts.size(); ++u) {
            counts[u] += counts[u - i];
        }
    }
    double all = 0.0;
    for (const double count : counts) {
        all += count;
    }
    for (double& count : counts) {
        count /= all;
    }
    return counts;
}

} // namespace

RankTest test_mann_whitney(std::span<const double> a, std::span<const double> b) {
    ALCOVE_ASSERT(!a.empty() && !b.empty(), "two groups");
    const std::vector<Labelled> sorted = sort_together(a, b);
    const Ranks ranks = rank_sorted(sorted, [](const Labelled& value) { return value.first; });
    std::size_t doubled_sum = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        doubled_sum += sorted[i].second ? ranks.doubled[i] : 0;
    }
    const auto n = static_cast<double>(a.size());
    const auto m = static_cast<double>(b.size());
    const double all = n + m;
    RankTest test;
    test.statistic = 0.5 * static_cast<double>(doubled_sum) - 0.5 * m * (m + 1.0);
    test.is_exact = ranks.tied_cubes == 0.0 && sorted.size() <= kMostExactRanks;
    if (test.is_exact) {
        test.p_value = sum_both_tails(count_mann_whitney(a.size(), b.size()),
                                      static_cast<std::size_t>(test.statistic));
    } else {
        const double variance = n * m / 12.0 * (all + 1.0 - ranks.tied_cubes / (all * (all - 1.0)));
        test.p_value = compute_normal_p_value(test.statistic - 0.5 * n * m, variance);
    }
    return test;
}

RankTest test_kolmogorov_smirnov(std::span<const double> a, std::span<const double> b) {
    ALCOVE_ASSERT(!a.empty() && !b.empty(), "two groups");
    const std::vector<Labelled> sorted = sort_together(a, b);
    const auto n = static_cast<std::int64_t>(a.size());
    const auto m = static_cast<std::int64_t>(b.size());
    // Distances in units of 1 / (n m) are whole. They count only where a run of ties is complete.
    const auto is_step = [&](std::size_t taken) {
        return taken == sorted.size() || sorted[taken].first != sorted[taken - 1].first;
    };
    std::int64_t i = 0;
    std::int64_t j = 0;
    std::int64_t largest = 0;
    for (std::size_t taken = 1; taken <= sorted.size(); ++taken) {
        ++(sorted[taken - 1].second ? j : i);
        if (is_step(taken)) {
            largest = std::max(largest, std::abs(i * m - j * n));
        }
    }
    RankTest test;
    test.statistic = static_cast<double>(largest) / static_cast<double>(n * m);
    if (largest == 0) {
        return test;
    }
    // All orders of the labels are equally likely: a walk from (0, 0) to (n, m) that takes the next
    // value from a with probability (n - i) / what is left. What reaches the distance is absorbed.
    std::vector<double> row(static_cast<std::size_t>(m) + 1, 0.0); // of one i, over j
    row[0] = 1.0;
    double absorbed = 0.0;
    for (i = 0; i <= n; ++i) {
        for (j = 0; j <= m; ++j) {
            double& here = row[static_cast<std::size_t>(j)];
            const auto taken = static_cast<std::size_t>(i + j);
            if (taken > 0 && is_step(taken) && std::abs(i * m - j * n) >= largest) {
                absorbed += here;
                here = 0.0;
            }
            if (taken < sorted.size()) {
                const auto left = static_cast<double>(sorted.size() - taken);
                if (j < m) {
                    row[static_cast<std::size_t>(j) + 1] +=
                        here * static_cast<double>(m - j) / left;
                }
                here *= static_cast<double>(n - i) / left; // goes on to the row of i + 1
            }
        }
    }
    test.p_value = std::min(1.0, absorbed);
    return test;
}

RankTest test_signed_ranks(std::span<const double> a, std::span<const double> b) {
    ALCOVE_ASSERT(a.size() == b.size() && !a.empty(), "pairs");
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] != b[i]) {
            differences.push_back(b[i] - a[i]);
        }
    }
    RankTest test;
    if (differences.empty()) {
        return test;
    }
    const auto magnitude = [](double value) { return std::abs(value); };
    std::sort(differences.begin(), differences.end(),
              [&](double x, double y) { return magnitude(x) < magnitude(y); });
    const Ranks ranks = rank_sorted(differences, magnitude);
    std::size_t doubled_sum = 0;
    std::size_t doubled_all = 0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        doubled_sum += differences[i] > 0.0 ? ranks.doubled[i] : 0;
        doubled_all += ranks.doubled[i];
    }
    test.statistic = 0.5 * static_cast<double>(doubled_sum);
    test.is_exact = differences.size() <= kMostExactPairs;
    if (test.is_exact) {
        std::vector<double> shares(doubled_all + 1, 0.0); // every sign is as likely as the other
        shares[0] = 1.0;
        for (const std::size_t rank : ranks.doubled) {
            for (std::size_t sum = shares.size(); sum-- > 0;) {
                shares[sum] = 0.5 * (shares[sum] + (sum >= rank ? shares[sum - rank] : 0.0));
            }
        }
        test.p_value = sum_both_tails(shares, doubled_sum);
    } else {
        const auto n = static_cast<double>(differences.size());
        const double variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ranks.tied_cubes / 48.0;
        test.p_value = compute_normal_p_value(
            test.statistic - 0.25 * static_cast<double>(doubled_all), variance);
    }
    return test;
}

} // namespace alcove
