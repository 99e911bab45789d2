#pragma once
// How far an error of one sign reaches beyond depth edges, in pixels. Ours.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit halo_width_unit();

} // namespace alcove
