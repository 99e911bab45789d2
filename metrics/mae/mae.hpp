#pragma once
// Mean absolute error, in units of the value (peak 1).

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit mae_unit();

} // namespace alcove
