#pragma once
// What a hit counts by its distance.

#include "core/base/target.hpp"

namespace alcove {

/// Weight of a hit at `relative_distance` = d / r in [0,1].
[[nodiscard]] inline float compute_falloff_weight(Falloff falloff, float relative_distance) {
    switch (falloff) {
    case Falloff::none:
        return 1.0f;
    case Falloff::linear:
        return 1.0f - relative_distance;
    case Falloff::quadratic:
        break;
    }
    return 1.0f - relative_distance * relative_distance;
}

} // namespace alcove
