#include "methods/common/traced_target.hpp"

#include <utility>

namespace alcove {
namespace {

void set(TargetMapping& mapping, const char* name, std::string value) {
    mapping.overrides.push_back({name, std::move(value), Provenance::target});
}

TargetMapping map_length(const Target& target) {
    TargetMapping mapping;
    set(mapping, "radius", to_text(ParameterValue{target.radius_m}));
    set(mapping, "falloff", std::string(to_text(target.falloff)));
    return mapping;
}

TargetMapping map_rays(const Target& target) {
    TargetMapping mapping = map_length(target);
    set(mapping, "weighting", std::string(to_text(target.weighting)));
    return mapping;
}

} // namespace

TargetMapping map_target_on_shading_normals(const Target& target) {
    TargetMapping mapping = map_rays(target);
    if (target.normals != Normals::shading) {
        mapping.reason = "geometric normals asked for, shading normals used";
    }
    return mapping;
}

TargetMapping map_whole_target(const Target& target) {
    TargetMapping mapping = map_rays(target);
    set(mapping, "normals", std::string(to_text(target.normals)));
    return mapping;
}

TargetMapping map_cosine_target(const Target& target) {
    TargetMapping mapping = map_length(target);
    set(mapping, "normals", std::string(to_text(target.normals)));
    if (target.weighting != Weighting::cosine) {
        mapping.reason = "uniform weighting asked for, light has the cosine";
    }
    return mapping;
}

} // namespace alcove
