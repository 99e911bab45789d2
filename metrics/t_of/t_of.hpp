#pragma once
// tOF: does what is seen move as truth moves?

#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] MetricUnit t_of_unit();

} // namespace alcove
