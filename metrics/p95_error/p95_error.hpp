#pragma once
// The absolute error that 95 % of the values do not exceed, in units of the value (peak 1).

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit p95_error_unit();

} // namespace alcove
