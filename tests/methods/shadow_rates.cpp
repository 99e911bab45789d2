#include "tests/methods/shadow_rates.hpp"

#include "methods/common/path_tracer.hpp"

namespace alcove {

LitLike::LitLike(const Scene& scene, Lights lights, int frame)
    : m_scene(scene), m_lights(std::move(lights)), m_walkthrough(scene.get_walkthrough()) {
    m_walkthrough.cameras = {scene.get_walkthrough().cameras.at(static_cast<std::size_t>(frame))};
    m_walkthrough.tracks.clear();
    m_walkthrough.events.clear();
    m_walkthrough.cuts.clear();
}

Image trace_shadows(const Scene& scene, ImageSize size) {
    PathTracer tracer;
    tracer.update(pose_geometry(scene, 0.0));
    PathSettings settings;
    settings.rays_per_half = 1;
    settings.bounces = 0;
    const auto trace = [&](bool casts_shadow) {
        Lights lights = scene.get_lights();
        for (DirectionalLight& light : lights.directional) {
            light.casts_shadow = casts_shadow;
        }
        for (PointLight& light : lights.points) {
            light.casts_shadow = casts_shadow;
        }
        return tracer.trace(scene.get_walkthrough().cameras.front(), size, lights, settings).direct;
    };
    const Image with = trace(true);
    const Image without = trace(false);
    Image truth(size, 1);
    for (std::size_t i = 0; i < truth.values().size(); ++i) {
        const float open = without.values()[3 * i + 1];
        truth.values()[i] =
            open > 1e-4f ? (with.values()[3 * i + 1] > 0.5f * open ? 1.0f : 0.0f) : 2.0f;
    }
    return truth;
}

ShadowRates compare_shadows(const Image& visibility, const Image& truth) {
    ShadowRates rates;
    int missing = 0;
    int wrong = 0;
    for (std::size_t i = 0; i < truth.values().size(); ++i) {
        const float expected = truth.values()[i];
        if (expected > 1.5f) {
            continue;
        }
        const bool is_shadowed = visibility.values()[i] < 0.5f;
        ++rates.count;
        rates.shadowed += expected < 0.5f ? 1 : 0;
        rates.found += is_shadowed ? 1 : 0;
        missing += expected < 0.5f && !is_shadowed ? 1 : 0;
        wrong += expected > 0.5f && is_shadowed ? 1 : 0;
    }
    rates.missing_share = double(missing) / rates.count;
    rates.false_share = double(wrong) / rates.count;
    return rates;
}

} // namespace alcove
