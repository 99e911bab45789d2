#pragma once
// How repeats and frames scatter, beyond their mean and interval: outliers, the memory of a
// machine, and slow frames. Nothing here is ever dropped from a result.
//
// This work is based on: Tukey. Exploratory data analysis. 1977 (fences). Anderson. Distribution of
// the serial correlation coefficient. 1942.

#include <cstddef>
#include <optional>
#include <span>

namespace alcove {

/// Tukey's classes: mild beyond 1.5, severe beyond 3 interquartile ranges from the quartiles (of
/// type 7). Of groups of six normal repeats 22 % have a mild one and 7 % a severe one: a few of
/// them mean nothing.
struct OutlierCount {
    std::size_t mild = 0;
    std::size_t severe = 0;
    std::size_t n = 0; ///< values looked at
    [[nodiscard]] bool any() const { return mild + severe > 0; }
};

/// Nothing under 5 values, where quartiles say nothing. Without spread between the quartiles every
/// other value is severe.
[[nodiscard]] std::optional<OutlierCount> classify_outliers(std::span<const double> values);

/// r_1: how much of one repeat's deviation from the mean is left in the next, in [-1,1]. Nothing
/// under 5 values or without any spread. About -1/n with a spread of 1/sqrt(n) for noise without
/// memory.
[[nodiscard]] std::optional<double> compute_lag1_autocorrelation(std::span<const double> values);

/// What r_1 of n values without memory exceeds in at most 5 % of cases (Anderson's normal
/// approximation): 0.46 for 6, in truth 2 % of cases; 0.29 for 24, in truth 4 %. Asserts 3 or more.
[[nodiscard]] double compute_lag1_bound(std::size_t n);

/// Two of the three numbers that go by "1 % low", as frame times; the third is the 99th percentile.
struct SlowFrames {
    /// Mean of the slowest 1 % of frames (rounded, at least one).
    double slowest_mean = 0.0;
    /// Slowest frames first, until they have taken 1 % of the total time: the time of the last.
    double time_integral = 0.0;
};

/// In the unit of `times`. Asserts one value or more.
[[nodiscard]] SlowFrames compute_slow_frames(std::span<const double> times);

} // namespace alcove
