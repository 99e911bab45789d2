#pragma once
// Peak signal-to-noise ratio in dB, peak 1.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit psnr_unit();

} // namespace alcove
