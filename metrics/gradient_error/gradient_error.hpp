#pragma once
// Gradient-domain error, in units of the value a pixel, and how much detail is kept. Ours.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit gradient_error_unit();

} // namespace alcove
