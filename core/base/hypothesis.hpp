#pragma once
// Is a difference more than noise? Student's t on two groups of repeats, and what many tests at
// once ask for.
//
// This work is based on: Welch. The generalization of "Student's" problem when several different
// population variances are involved. 1947. Satterthwaite. An approximate distribution of estimates
// of variance components. 1946. Holm. A simple sequentially rejective multiple test procedure.
// 1979. Benjamini, Hochberg. Controlling the false discovery rate. 1995.

#include "core/base/statistics.hpp"

#include <span>
#include <vector>

namespace alcove {

/// How far two means lie apart, and how surprising that is if they are equal in truth.
struct MeanTest {
    double difference = 0.0;
    Interval interval;               ///< 95 %, of the difference
    double degrees_of_freedom = 0.0; ///< Welch-Satterthwaite: not whole
    double p_value = 1.0;            ///< two-sided
};

/// Two-sided p-value of Student's t: 0.05 for t = 2.5706 at 5 degrees of freedom.
[[nodiscard]] double compute_student_p_value(double t, double degrees_of_freedom);

/// mean(b) - mean(a) of independent groups that may spread differently (Welch). Two groups without
/// any spread have p 1 if they are equal, else 0. Asserts two values or more in each.
[[nodiscard]] MeanTest test_independent_means(std::span<const double> a, std::span<const double> b);

/// Mean of b[i] - a[i]: takes out what a pair shares. Asserts equal sizes and two pairs or more.
[[nodiscard]] MeanTest test_paired_means(std::span<const double> a, std::span<const double> b);

/// p-values adjusted for being `p_values.size()` tests at once: rejecting what is at most 0.05
/// rejects any true hypothesis in at most 5 % of families, however the tests depend on each other.
[[nodiscard]] std::vector<double> adjust_holm(std::span<const double> p_values);

/// p-values adjusted so that among those at most q at most a share q is expected to be false
/// discoveries (if the tests are independent or depend positively). Never larger than Holm's.
[[nodiscard]] std::vector<double> adjust_benjamini_hochberg(std::span<const double> p_values);

} // namespace alcove
