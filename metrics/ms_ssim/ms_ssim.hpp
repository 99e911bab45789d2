#pragma once
// Multi-scale structural similarity on views, with either published low-pass.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit ms_ssim_unit();

} // namespace alcove
