#include "core/base/statistics.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <boost/math/distributions/students_t.hpp>

namespace alcove {

double compute_quantile(std::span<const double> values, double p) {
    ALCOVE_ASSERT(!values.empty(), "a quantile of something");
    ALCOVE_ASSERT(p >= 0.0 && p <= 1.0, "a probability");
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const double position = p * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double fraction = position - static_cast<double>(below);
    return sorted[below] + fraction * (sorted[above] - sorted[below]);
}

double compute_median(std::span<const double> values) {
    return compute_quantile(values, 0.5);
}

double compute_mean(std::span<const double> values) {
    ALCOVE_ASSERT(!values.empty(), "a mean of something");
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double compute_standard_deviation(std::span<const double> values) {
    ALCOVE_ASSERT(values.size() >= 2, "a spread of two values or more");
    const double mean = compute_mean(values);
    double sum = 0.0;
    for (const double value : values) {
        sum += (value - mean) * (value - mean);
    }
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

double compute_student_t95(std::size_t degrees_of_freedom) {
    ALCOVE_ASSERT(degrees_of_freedom >= 1, "degrees of freedom");
    const boost::math::students_t distribution(static_cast<double>(degrees_of_freedom));
    return boost::math::quantile(distribution, 0.975);
}

Estimate estimate_across_repeats(std::span<const double> per_repeat) {
    Estimate estimate;
    estimate.n = per_repeat.size();
    estimate.value = compute_mean(per_repeat);
    const auto [minimum, maximum] = std::minmax_element(per_repeat.begin(), per_repeat.end());
    estimate.minimum = *minimum;
    estimate.maximum = *maximum;
    if (estimate.n >= kMinimumRepeatsForInterval) {
        const double half_width = compute_student_t95(estimate.n - 1) *
                                  compute_standard_deviation(per_repeat) /
                                  std::sqrt(static_cast<double>(estimate.n));
        estimate.interval = Interval{estimate.value - half_width, estimate.value + half_width};
    }
    return estimate;
}

std::vector<double> compute_paired_log_ratios(const RepeatsByFrames& a, const RepeatsByFrames& b) {
    ALCOVE_ASSERT(a.size() == b.size(), "paired repeats");
    std::vector<double> per_repeat;
    for (std::size_t repeat = 0; repeat < a.size(); ++repeat) {
        ALCOVE_ASSERT(a[repeat].size() == b[repeat].size(), "paired frames");
        std::vector<double> logs;
        for (std::size_t frame = 0; frame < a[repeat].size(); ++frame) {
            const double ratio = a[repeat][frame] / b[repeat][frame];
            if (std::isfinite(ratio) && ratio > 0.0) {
                logs.push_back(std::log(ratio));
            }
        }
        per_repeat.push_back(logs.empty() ? std::numeric_limits<double>::quiet_NaN()
                                          : compute_median(logs));
    }
    return per_repeat;
}

Estimate exponentiate(Estimate of_logs) {
    of_logs.value = std::exp(of_logs.value);
    of_logs.minimum = std::exp(of_logs.minimum);
    of_logs.maximum = std::exp(of_logs.maximum);
    if (of_logs.interval) {
        of_logs.interval =
            Interval{std::exp(of_logs.interval->lower), std::exp(of_logs.interval->upper)};
    }
    return of_logs;
}

std::optional<Estimate> estimate_paired_ratio(const RepeatsByFrames& a, const RepeatsByFrames& b) {
    std::vector<double> per_repeat = compute_paired_log_ratios(a, b);
    std::erase_if(per_repeat, [](double value) { return std::isnan(value); });
    if (per_repeat.empty()) {
        return std::nullopt;
    }
    return exponentiate(estimate_across_repeats(per_repeat));
}

double compute_minimum_detectable_effect(const Estimate& aa_ratio) {
    const Interval interval =
        aa_ratio.interval.value_or(Interval{aa_ratio.minimum, aa_ratio.maximum});
    return std::max(std::abs(interval.lower - 1.0), std::abs(interval.upper - 1.0));
}

} // namespace alcove
