#pragma once
// Largest absolute error, in units of the value (peak 1).

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit max_error_unit();

} // namespace alcove
