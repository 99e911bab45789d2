#pragma once
// HDR-FLIP: the largest LDR-FLIP of each pixel over the exposures at which radiance can be seen.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit hdr_flip_unit();

} // namespace alcove
