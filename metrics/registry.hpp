#pragma once
// All metrics, from the one list in metrics/CMakeLists.txt. registry.cpp is generated.

#include "core/base/registry.hpp"
#include "core/contract/metric.hpp"

namespace alcove {

[[nodiscard]] Registry<MetricUnit> metrics_registry();

} // namespace alcove
