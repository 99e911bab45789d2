#pragma once
// Structural similarity on views, with the definition's window and the valid region only.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit ssim_unit();

} // namespace alcove
