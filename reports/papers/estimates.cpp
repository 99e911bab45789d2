#include "reports/papers/estimates.hpp"

#include "core/base/assert.hpp"

#include <cmath>

namespace alcove {

Estimate make_single(double value) {
    Estimate estimate;
    estimate.value = value;
    estimate.minimum = value;
    estimate.maximum = value;
    estimate.n = 1;
    return estimate;
}

Estimate scale_estimate(Estimate estimate, double factor) {
    ALCOVE_ASSERT(factor > 0.0, "a factor that keeps the order");
    estimate.value *= factor;
    estimate.minimum *= factor;
    estimate.maximum *= factor;
    if (estimate.interval) {
        estimate.interval =
            Interval{estimate.interval->lower * factor, estimate.interval->upper * factor};
    }
    return estimate;
}

Estimate correlate(const std::vector<double>& a, const std::vector<double>& b) {
    ALCOVE_ASSERT(a.size() == b.size() && a.size() >= 4, "two series of four or more");
    const double mean_a = compute_mean(a);
    const double mean_b = compute_mean(b);
    double ab = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    const double r = ab / std::sqrt(aa * bb);
    const double width = 1.959964 / std::sqrt(static_cast<double>(a.size()) - 3.0);
    Estimate estimate = make_single(r);
    estimate.interval =
        Interval{std::tanh(std::atanh(r) - width), std::tanh(std::atanh(r) + width)};
    estimate.n = a.size();
    return estimate;
}

Estimate estimate_linearity(const std::vector<double>& x,
                            const std::vector<std::map<int, double>>& times) {
    ALCOVE_ASSERT(x.size() == times.size() && !times.empty(), "a series an x");
    std::vector<double> fits;
    for (const auto& [repeat, first] : times.front()) {
        std::vector<double> of_repeat;
        for (const std::map<int, double>& series : times) {
            of_repeat.push_back(series.at(repeat));
        }
        const double r = correlate(x, of_repeat).value;
        fits.push_back(r * r);
    }
    return estimate_across_repeats(fits);
}

Outcome judge_order(const Estimate& higher, const Estimate& lower, double slack) {
    if (!higher.interval || !lower.interval) {
        return Outcome::inconclusive;
    }
    if (higher.interval->lower >= lower.interval->upper - slack) {
        return Outcome::holds;
    }
    return higher.interval->upper < lower.interval->lower - slack ? Outcome::fails
                                                                  : Outcome::inconclusive;
}

} // namespace alcove
