#pragma once
// Gradient magnitude similarity deviation on views: how unevenly edges are kept.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit gmsd_unit();

} // namespace alcove
