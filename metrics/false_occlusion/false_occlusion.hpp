#pragma once
// How many pixels are darker than they should be: self-occlusion of planes, dark halos. Ours.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit false_occlusion_unit();

} // namespace alcove
