#include "harness/run/units.hpp"

#include "methods/registry.hpp"
#include "metrics/registry.hpp"
#include "scenes/registry.hpp"

namespace alcove {

Units get_units() {
    return {methods_registry(), metrics_registry(), scenes_registry()};
}

} // namespace alcove
