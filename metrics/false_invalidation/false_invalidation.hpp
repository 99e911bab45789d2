#pragma once
// How much of what truth says is still good a method's history drops.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit false_invalidation_unit();

} // namespace alcove
