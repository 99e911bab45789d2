#pragma once
// Bands that run along the rows of an image, in the profile across them. Ours.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit band_profile_unit();

} // namespace alcove
