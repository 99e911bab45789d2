#pragma once
// What the descriptions of several methods have in common.

#include "core/contract/method.hpp"

#include <initializer_list>
#include <utility>
#include <vector>

namespace alcove {

using PresetSettings = std::initializer_list<std::pair<const char*, const char*>>;
/// {"name", "value"} pairs as a preset's row.
[[nodiscard]] std::vector<ParameterOverride> make_overrides(PresetSettings settings);

/// For estimators whose parameter `radius` is the target's and whose step lengths give linear
/// falloff and cosine weighting with the G-buffer's shading normals: maps the radius, and says what
/// of the rest it is not.
[[nodiscard]] TargetMapping map_linear_cosine_target(const Target& target);

} // namespace alcove
