#pragma once
// Root mean squared error, in units of the value.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit rmse_unit();

} // namespace alcove
