#pragma once
// How many frames old the truth is that is mixed into the test image.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit lag_frames_unit();

} // namespace alcove
