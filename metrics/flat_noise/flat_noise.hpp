#pragma once
// Fine noise where the reference is flat, in units of the value. Ours.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit flat_noise_unit();

} // namespace alcove
