#pragma once
// LDR-FLIP: how large the difference looks to somebody who flips between the two views.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit flip_unit();

} // namespace alcove
