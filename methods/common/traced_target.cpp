#include "methods/common/traced_target.hpp"

#include <utility>

namespace alcove {
namespace {

TargetMapping map_rays(const Target& target) {
    TargetMapping mapping;
    const auto set = [&mapping](const char* name, std::string value) {
        mapping.overrides.push_back({name, std::move(value), Provenance::target});
    };
    set("radius", to_text(ParameterValue{target.radius_m}));
    set("falloff", std::string(to_text(target.falloff)));
    set("weighting", std::string(to_text(target.weighting)));
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
    mapping.overrides.push_back(
        {"normals", std::string(to_text(target.normals)), Provenance::target});
    return mapping;
}

} // namespace alcove
