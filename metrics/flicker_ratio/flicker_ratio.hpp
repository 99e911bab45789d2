#pragma once
// How much of the error changes from frame to frame: 0 sticks to surfaces, 1 is white in time.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit flicker_ratio_unit();

} // namespace alcove
