#pragma once
// How much the error changes from frame to frame along the surfaces, in units of the value.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit temporal_flicker_unit();

} // namespace alcove
