#include "methods/common/shadow_light.hpp"

namespace alcove {

ShadowLight make_shadow_light(const DirectionalLight& light, const BoundingSphere& sphere) {
    return {false,
            light.to_light,
            light.irradiance,
            std::nullopt,
            {look_along(light, sphere)},
            light.casts_shadow};
}

std::vector<ShadowLight> list_shadow_lights(const Lights& lights, const BoundingSphere& sphere) {
    std::vector<ShadowLight> list;
    for (const DirectionalLight& light : lights.directional) {
        list.push_back(make_shadow_light(light, sphere));
    }
    for (const PointLight& light : lights.points) {
        ShadowLight entry{true, light.position,    light.intensity, light.cone,
                          {},   light.casts_shadow};
        if (light.cone) {
            entry.views = {look_along(light, sphere)};
        } else {
            const auto faces = look_around(light, sphere);
            entry.views.assign(faces.begin(), faces.end());
        }
        list.push_back(std::move(entry));
    }
    return list;
}

} // namespace alcove
