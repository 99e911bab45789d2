#pragma once
// `metric --self-test`: the check values of the definitions.

#include "core/contract/metric.hpp"

#include <string>
#include <vector>

namespace alcove {

/// Evaluates every check of the units that `names` speaks of (all that are reported where it is
/// empty) and prints expected, got, difference, tolerance and source: a line each, or one JSON
/// object `{"checks":[...],"failed":n}`. Throws InputError on an unknown name, FailureError if a
/// check does not hold.
void run_self_test(const Registry<MetricUnit>& registry, const std::vector<std::string>& names,
                   bool as_json);

} // namespace alcove
