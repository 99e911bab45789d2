#include "core/base/hypothesis.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/math/distributions/students_t.hpp>

namespace alcove {
namespace {

MeanTest make_test(double difference, double standard_error, double degrees_of_freedom) {
    MeanTest test;
    test.difference = difference;
    test.degrees_of_freedom = degrees_of_freedom;
    if (standard_error > 0.0) {
        const boost::math::students_t distribution(degrees_of_freedom);
        const double half_width = boost::math::quantile(distribution, 0.975) * standard_error;
        test.interval = {difference - half_width, difference + half_width};
        test.p_value = compute_student_p_value(difference / standard_error, degrees_of_freedom);
    } else {
        test.interval = {difference, difference};
        test.p_value = difference == 0.0 ? 1.0 : 0.0;
    }
    return test;
}

/// Squared standard error of the mean.
double compute_mean_variance(std::span<const double> values) {
    const double deviation = compute_standard_deviation(values);
    return deviation * deviation / static_cast<double>(values.size());
}

/// Places of the values, the smallest first.
std::vector<std::size_t> order_ascending(std::span<const double> values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    return order;
}

} // namespace

double compute_student_p_value(double t, double degrees_of_freedom) {
    ALCOVE_ASSERT(degrees_of_freedom > 0.0, "degrees of freedom");
    const boost::math::students_t distribution(degrees_of_freedom);
    return 2.0 * boost::math::cdf(boost::math::complement(distribution, std::abs(t)));
}

MeanTest test_independent_means(std::span<const double> a, std::span<const double> b) {
    const double variance_a = compute_mean_variance(a);
    const double variance_b = compute_mean_variance(b);
    const double variance = variance_a + variance_b;
    const double freedom_a = static_cast<double>(a.size() - 1);
    const double freedom_b = static_cast<double>(b.size() - 1);
    // Shares first: squares of tiny variances would underflow.
    const double share_a = variance > 0.0 ? variance_a / variance : 0.5;
    const double share_b = 1.0 - share_a;
    const double freedom = 1.0 / (share_a * share_a / freedom_a + share_b * share_b / freedom_b);
    return make_test(compute_mean(b) - compute_mean(a), std::sqrt(variance), freedom);
}

MeanTest test_paired_means(std::span<const double> a, std::span<const double> b) {
    ALCOVE_ASSERT(a.size() == b.size(), "pairs");
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i) {
        differences.push_back(b[i] - a[i]);
    }
    return make_test(compute_mean(differences), std::sqrt(compute_mean_variance(differences)),
                     static_cast<double>(differences.size() - 1));
}

std::vector<double> adjust_holm(std::span<const double> p_values) {
    const std::vector<std::size_t> order = order_ascending(p_values);
    std::vector<double> adjusted(p_values.size());
    double largest = 0.0;
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        const double scaled = static_cast<double>(order.size() - rank) * p_values[order[rank]];
        largest = std::max(largest, std::min(1.0, scaled));
        adjusted[order[rank]] = largest;
    }
    return adjusted;
}

std::vector<double> adjust_benjamini_hochberg(std::span<const double> p_values) {
    const std::vector<std::size_t> order = order_ascending(p_values);
    std::vector<double> adjusted(p_values.size());
    double smallest = 1.0;
    for (std::size_t rank = order.size(); rank-- > 0;) {
        const double scaled = static_cast<double>(order.size()) * p_values[order[rank]] /
                              static_cast<double>(rank + 1);
        smallest = std::min(smallest, scaled);
        adjusted[order[rank]] = smallest;
    }
    return adjusted;
}

} // namespace alcove
