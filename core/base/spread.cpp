#include "core/base/spread.hpp"

#include "core/base/assert.hpp"
#include "core/base/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace alcove {
namespace {

/// Fewest values of which quartiles and memory are asked.
constexpr std::size_t kFewest = kMinimumRepeatsForInterval;

constexpr double kMildFence = 1.5;
constexpr double kSevereFence = 3.0;

} // namespace

std::optional<OutlierCount> classify_outliers(std::span<const double> values) {
    if (values.size() < kFewest) {
        return std::nullopt;
    }
    const double lower = compute_quantile(values, 0.25);
    const double upper = compute_quantile(values, 0.75);
    const double range = upper - lower;
    OutlierCount count;
    count.n = values.size();
    for (const double value : values) {
        const double beyond = std::max(lower - value, value - upper);
        if (beyond > kSevereFence * range) {
            ++count.severe;
        } else if (beyond > kMildFence * range) {
            ++count.mild;
        }
    }
    return count;
}

std::optional<double> compute_lag1_autocorrelation(std::span<const double> values) {
    if (values.size() < kFewest) {
        return std::nullopt;
    }
    const double mean = compute_mean(values);
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double deviation = values[i] - mean;
        squares += deviation * deviation;
        products += i > 0 ? deviation * (values[i - 1] - mean) : 0.0;
    }
    return squares > 0.0 ? std::optional(products / squares) : std::nullopt;
}

double compute_lag1_bound(std::size_t n) {
    ALCOVE_ASSERT(n >= 3, "a series");
    constexpr double kFivePercent = 1.6449; // of the normal distribution, one-sided
    const auto count = static_cast<double>(n);
    return (kFivePercent * std::sqrt(count - 2.0) - 1.0) / (count - 1.0);
}

SlowFrames compute_slow_frames(std::span<const double> times) {
    ALCOVE_ASSERT(!times.empty(), "times of something");
    std::vector<double> sorted(times.begin(), times.end());
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    constexpr double kShare = 0.01;
    SlowFrames slow;
    const auto slowest =
        std::max<std::ptrdiff_t>(1, std::llround(kShare * static_cast<double>(sorted.size())));
    slow.slowest_mean = std::accumulate(sorted.begin(), sorted.begin() + slowest, 0.0) /
                        static_cast<double>(slowest);
    const double goal = kShare * std::accumulate(sorted.begin(), sorted.end(), 0.0);
    double sum = 0.0;
    for (const double time : sorted) {
        sum += time;
        slow.time_integral = time;
        if (sum >= goal) {
            break;
        }
    }
    return slow;
}

} // namespace alcove
