#pragma once
// How many frames a point that comes into view takes to be as good as one that never left it.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit recovery_frames_unit();

} // namespace alcove
