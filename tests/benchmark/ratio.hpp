#pragma once
// A target as the benchmarks print it: one line, and the exit code of a gate.

#include <functional>
#include <string>
#include <vector>

namespace alcove {

/// Wall seconds of one call.
[[nodiscard]] double time_call(const std::function<void()>& call);

/// Calls a and b in turn, `count` times each behind one untimed call of both, and returns the
/// ratios a / b of neighbours: drift falls on both alike.
[[nodiscard]] std::vector<double> time_in_turn(const std::function<void()>& a,
                                               const std::function<void()>& b, int count);

/// Prints "name | target | median (min..max) | n | met" and returns whether the median holds: at
/// most the bound, or, if `at_least`, not less.
bool print_target(const std::string& name, double bound, bool at_least,
                  const std::vector<double>& ratios);

} // namespace alcove
