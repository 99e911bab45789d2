#pragma once
// Energy of false steps on views, where the reference is smooth. Ours.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit banding_energy_unit();

} // namespace alcove
