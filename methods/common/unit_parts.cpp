#include "methods/common/unit_parts.hpp"

namespace alcove {

std::vector<ParameterOverride> make_overrides(PresetSettings settings) {
    std::vector<ParameterOverride> overrides;
    for (const auto& [name, value] : settings) {
        overrides.push_back({name, value, Provenance::preset});
    }
    return overrides;
}

TargetMapping map_radius(const Target& target, const EstimatorResponse& response) {
    TargetMapping mapping;
    mapping.overrides = {
        {"radius", to_text(ParameterValue{target.radius_m}), Provenance::target},
    };
    const auto compare = [&mapping](const char* what, std::string_view asked,
                                    const std::string& computed) {
        if (asked != computed) {
            mapping.reason += (mapping.reason.empty() ? "" : "; ") + std::string(what) + " " +
                              std::string(asked) + " asked for, computed: " + computed;
        }
    };
    compare("falloff", to_text(target.falloff), response.falloff);
    compare("weighting", to_text(target.weighting), response.weighting);
    compare("normals", to_text(target.normals), "shading");
    return mapping;
}

SampleCount count_estimator_samples(const std::string& method, int samples,
                                    bool is_half_resolution) {
    return {method + "/occlusion", (is_half_resolution ? 0.25 : 1.0) * samples};
}

TargetMapping map_linear_cosine_target(const Target& target) {
    return map_radius(target, {"linear", "cosine"});
}

} // namespace alcove
