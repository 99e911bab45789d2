#pragma once
// How many stops of light an image or a region has too much or too little.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit energy_ratio_unit();

} // namespace alcove
