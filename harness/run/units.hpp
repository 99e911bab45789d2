#pragma once
// The rooms a run draws on.

#include "core/contract/method.hpp"
#include "core/contract/metric.hpp"
#include "core/contract/scene.hpp"

namespace alcove {

struct Units {
    Registry<MethodUnit> methods;
    Registry<MetricUnit> metrics;
    Registry<SceneUnit> scenes;
};
[[nodiscard]] Units get_units();

} // namespace alcove
