#pragma once
// What a newcomer copies: the largest absolute difference. Compiled and tested, never reported.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit template_metric_unit();

} // namespace alcove
