#pragma once
// What the descriptions of several methods have in common.

#include "core/contract/method.hpp"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace alcove {

using PresetSettings = std::initializer_list<std::pair<const char*, const char*>>;
/// {"name", "value"} pairs as a preset's row.
[[nodiscard]] std::vector<ParameterOverride> make_overrides(PresetSettings settings);

/// What an estimator computes of a target beside its radius, in the words of a target ("linear",
/// "cosine") where it is one of them.
struct EstimatorResponse {
    std::string falloff;
    std::string weighting;
};

/// For estimators over the G-buffer's shading normals whose parameter `radius` is the target's:
/// maps the radius, and says what of the rest the estimator is not.
[[nodiscard]] TargetMapping map_radius(const Target& target, const EstimatorResponse& response);

/// count_samples of a method on EstimatorMethod: its occlusion pass takes `samples` at every pixel,
/// or at every fourth.
[[nodiscard]] SampleCount count_estimator_samples(const std::string& method, int samples,
                                                  bool is_half_resolution);

/// Step lengths that are uniform give linear falloff.
[[nodiscard]] TargetMapping map_linear_cosine_target(const Target& target);

} // namespace alcove
