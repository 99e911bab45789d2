#pragma once
// Warping error of the test alone: how much it changes along the surfaces, right or wrong.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit warping_error_unit();

} // namespace alcove
