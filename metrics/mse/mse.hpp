#pragma once
// Mean squared error, in units of the squared value (peak 1): tables in code units are 65025 times
// this.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit mse_unit();

} // namespace alcove
