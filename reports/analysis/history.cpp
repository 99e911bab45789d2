#include "reports/analysis/history.hpp"

#include "core/base/assert.hpp"
#include "core/base/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace alcove {
namespace {

constexpr double kFenceRanges = 3.0; ///< interquartile ranges above the third quartile

/// What is remembered of one segment.
struct Past {
    std::vector<double> values;      ///< the last kBaselineNights since the last step
    std::vector<double> differences; ///< absolute; the last kFenceDifferences
};

void remember(std::vector<double>& values, double value, std::size_t most) {
    if (values.size() == most) {
        values.erase(values.begin());
    }
    values.push_back(value);
}

double compute_fence(const std::vector<double>& differences, double baseline,
                     const HistoryRule& rule) {
    const double q1 = compute_quantile(differences, 0.25);
    const double q3 = compute_quantile(differences, 0.75);
    return std::max(q3 + kFenceRanges * (q3 - q1), rule.relative_fence * std::abs(baseline));
}

HistoryNight judge(double value, const Past& past, const HistoryRule& rule) {
    HistoryNight night;
    night.past_differences = past.differences.size();
    if (past.values.empty()) {
        return night;
    }
    night.baseline = compute_median(past.values);
    night.difference = compute_difference(value, *night.baseline, rule);
    if (past.differences.size() >= kFewestDifferences) {
        night.fence = compute_fence(past.differences, *night.baseline, rule);
    }
    return night;
}

} // namespace

bool HistoryNight::is_beyond() const {
    return difference && fence && std::abs(*difference) > *fence;
}

std::vector<HistoryNight> replay_history(std::span<const HistoryPoint> points,
                                         const HistoryRule& rule) {
    std::map<std::int64_t, Past> segments;
    std::vector<HistoryNight> nights;
    nights.reserve(points.size());
    for (const HistoryPoint& point : points) {
        Past& past = segments[point.segment];
        const HistoryNight& night = nights.emplace_back(judge(point.value, past, rule));
        if (point.is_step) {
            past.values.clear();
        } else if (night.difference) {
            remember(past.differences, std::abs(*night.difference), kFenceDifferences);
        }
        remember(past.values, point.value, kBaselineNights);
    }
    return nights;
}

double compute_difference(double value, double baseline, const HistoryRule& rule) {
    if (!rule.is_logarithmic) {
        return value - baseline;
    }
    ALCOVE_ASSERT(value > 0.0 && baseline > 0.0, "values with a logarithm");
    return std::log(value / baseline);
}

bool is_repeated(const HistoryNight& night, double second, const HistoryRule& rule) {
    if (!night.is_beyond()) {
        return false;
    }
    const double again = compute_difference(second, *night.baseline, rule);
    return std::abs(again) > *night.fence && (again > 0.0) == (*night.difference > 0.0);
}

} // namespace alcove
