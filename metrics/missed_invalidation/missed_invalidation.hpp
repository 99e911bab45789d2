#pragma once
// How much of what truth says is stale a method's history keeps.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit missed_invalidation_unit();

} // namespace alcove
