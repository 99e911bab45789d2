#include "reports/papers/verdict.hpp"

#include <algorithm>

namespace alcove {
namespace {

Interval get_bounds(const Estimate& measured) {
    return measured.interval.value_or(Interval{measured.minimum, measured.maximum});
}

} // namespace

Outcome judge_above(const Estimate& measured, double bound) {
    const Interval bounds = get_bounds(measured);
    return bounds.lower > bound   ? Outcome::holds
           : bounds.upper < bound ? Outcome::fails
                                  : Outcome::inconclusive;
}

Outcome judge_below(const Estimate& measured, double bound) {
    const Interval bounds = get_bounds(measured);
    return bounds.upper < bound   ? Outcome::holds
           : bounds.lower > bound ? Outcome::fails
                                  : Outcome::inconclusive;
}

Outcome judge_within(const Estimate& measured, double lower, double upper) {
    const Interval bounds = get_bounds(measured);
    if (bounds.lower >= lower && bounds.upper <= upper) {
        return Outcome::holds;
    }
    return bounds.upper < lower || bounds.lower > upper ? Outcome::fails : Outcome::inconclusive;
}

Outcome combine(const std::vector<Outcome>& outcomes) {
    const auto has = [&outcomes](Outcome outcome) {
        return std::find(outcomes.begin(), outcomes.end(), outcome) != outcomes.end();
    };
    return has(Outcome::fails)          ? Outcome::fails
           : has(Outcome::not_testable) ? Outcome::not_testable
           : has(Outcome::inconclusive) ? Outcome::inconclusive
                                        : Outcome::holds;
}

} // namespace alcove
