#include "methods/common/unit_parts.hpp"

namespace alcove {

std::vector<ParameterOverride> make_overrides(PresetSettings settings) {
    std::vector<ParameterOverride> overrides;
    for (const auto& [name, value] : settings) {
        overrides.push_back({name, value, Provenance::preset});
    }
    return overrides;
}

TargetMapping map_linear_cosine_target(const Target& target) {
    TargetMapping mapping;
    mapping.overrides = {
        {"radius", to_text(ParameterValue{target.radius_m}), Provenance::target},
    };
    const auto add = [&mapping](const std::string& reason) {
        mapping.reason += (mapping.reason.empty() ? "" : "; ") + reason;
    };
    if (target.falloff != Falloff::linear) {
        add("falloff " + std::string(to_text(target.falloff)) +
            " asked for, linear computed: the step length is uniform");
    }
    if (target.weighting != Weighting::cosine) {
        add("weighting uniform asked for, cosine computed");
    }
    if (target.normals != Normals::shading) {
        add("geometric normals asked for, the G-buffer's shading normals used");
    }
    return mapping;
}

} // namespace alcove
