#pragma once
// The error where truth has just brightened: the dark trails behind what moves.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit trail_energy_unit();

} // namespace alcove
