#pragma once
// How much of an older truth is mixed into the test image.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit lag_share_unit();

} // namespace alcove
