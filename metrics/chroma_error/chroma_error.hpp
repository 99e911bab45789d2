#pragma once
// How far colours are from the reference's in the chroma plane of CIELAB, whatever their lightness.

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit chroma_error_unit();

} // namespace alcove
