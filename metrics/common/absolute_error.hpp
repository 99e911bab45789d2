#pragma once
// What mae, p95_error and max_error are made of: |test - reference| of every counted value.

#include "metrics/common/pooled_region.hpp"

#include <functional>

namespace alcove {

/// Reduces |test - reference| over all counted pixels and channels with `pool`, which may reorder
/// them; never called with none. With halves A, B of the reference, `floor` is the same of
/// |A - B| / 2, what the reference's own noise gives. The map is |test - reference|, averaged over
/// channels.
[[nodiscard]] MetricResult
pool_absolute_error(const MetricInput& input,
                    const std::function<double(std::vector<float>&)>& pool);

} // namespace alcove
