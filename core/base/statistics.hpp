#pragma once
// The statistics of DESIGN 3.6. The unit of inference is the repeat: frames within a repeat are
// correlated, so resampling them would claim far more than is known (64 to 67 % coverage where 95 %
// is said).

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace alcove {

/// Fewest repeats for which an interval is given.
inline constexpr std::size_t kMinimumRepeatsForInterval = 5;

/// Middle value; mean of the two middle ones for an even count. Asserts that there is a value.
[[nodiscard]] double compute_median(std::span<const double> values);
/// Quantile by linear interpolation between order statistics (type 7 of Hyndman and Fan 1996). `p`
/// in [0,1].
[[nodiscard]] double compute_quantile(std::span<const double> values, double p);
[[nodiscard]] double compute_mean(std::span<const double> values);
/// With n - 1 in the denominator. Asserts two values or more.
[[nodiscard]] double compute_standard_deviation(std::span<const double> values);
/// Two-sided 95 % point of Student's t: 2.5706 for 5 degrees of freedom.
[[nodiscard]] double compute_student_t95(std::size_t degrees_of_freedom);

struct Interval {
    double lower = 0.0;
    double upper = 0.0;
};

/// A number that was sampled, with what is known of its error.
struct Estimate {
    double value = 0.0;
    std::optional<Interval> interval; ///< 95 %, Student t across repeats; none under 5 repeats
    double minimum = 0.0;             ///< over repeats
    double maximum = 0.0;
    std::size_t n = 0; ///< repeats
};

/// Mean across repeats with its interval. Asserts one value or more.
[[nodiscard]] Estimate estimate_across_repeats(std::span<const double> per_repeat);

/// One number for every frame of every repeat; NaN where a frame has no sample in that repeat.
using RepeatsByFrames = std::vector<std::vector<double>>;

/// In each repeat the median over frames of log(a/b); NaN for a repeat without any pair. Frames
/// without a sample in either are left out. Asserts equal shapes.
[[nodiscard]] std::vector<double> compute_paired_log_ratios(const RepeatsByFrames& a,
                                                            const RepeatsByFrames& b);

/// The estimate of a ratio from that of its logarithm.
[[nodiscard]] Estimate exponentiate(Estimate of_logs);

/// Ratio a/b: in each repeat the median over frames of log(a/b), across repeats Student t on the
/// logs, then exp. Frames without a sample in either are left out; a repeat without any pair is
/// left out of n. Returns nothing if no repeat has a pair. Asserts equal shapes.
[[nodiscard]] std::optional<Estimate> estimate_paired_ratio(const RepeatsByFrames& a,
                                                            const RepeatsByFrames& b);

/// Smallest relative effect that an A/A pair lets one believe in: the larger distance from 1 of the
/// ends of the A/A ratio's interval (of its extremes under 5 repeats).
[[nodiscard]] double compute_minimum_detectable_effect(const Estimate& aa_ratio);

} // namespace alcove
