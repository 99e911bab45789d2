#include "tests/methods/scene_shots.hpp"

#include "core/base/text.hpp"
#include "methods/registry.hpp"
#include "scenes/registry.hpp"

#include <cmath>

namespace alcove {
namespace {

std::vector<ParameterOverride> read_settings(const std::string& settings) {
    std::vector<ParameterOverride> overrides;
    if (!settings.empty()) {
        for (const KeyValue& entry : parse_key_values(settings, "settings")) {
            overrides.push_back({entry.key, entry.value});
        }
    }
    return overrides;
}

std::unique_ptr<Scene> open(const std::string& name, const std::string& settings) {
    const Registry<SceneUnit> registry = scenes_registry();
    const SceneUnit& unit = registry.find(name);
    ALCOVE_ASSERT(!unit.find_obstacle(), "a scene that can be opened");
    return unit.open(unit.parameters.resolve(read_settings(settings), {}));
}

} // namespace

SceneShots::SceneShots(gl::Context& context, const std::string& scene, const std::string& settings,
                       ImageSize size)
    : m_context(context), m_size(size), m_scene(open(scene, settings)),
      m_rig(context, *m_scene, size) {}

std::unique_ptr<Method> SceneShots::make_method(const std::string& specification) const {
    const std::size_t colon = specification.find(':');
    const std::string name = specification.substr(0, colon);
    const std::size_t at = name.find('@');
    const Registry<MethodUnit> registry = methods_registry();
    const MethodUnit& unit = registry.find(name.substr(0, at));
    std::vector<ParameterOverride> overrides =
        unit.find_preset(at == std::string::npos ? "default" : name.substr(at + 1)).overrides;
    for (const ParameterOverride& own :
         read_settings(colon == std::string::npos ? "" : specification.substr(colon + 1))) {
        overrides.push_back(own);
    }
    const ResolvedParameters resolved =
        unit.parameters.resolve(overrides, {{"scene_radius", m_scene->get_ao_radius_m()}});
    std::unique_ptr<Method> method = unit.create(m_context, resolved);
    method->resize(m_size);
    return method;
}

RigShot SceneShots::shoot(Method& method, const FrameView& view, std::uint32_t seed) {
    return m_rig.shoot(method, view, {seed, true, {}});
}

RigShot SceneShots::converge(Method& method, int frame, int frames) {
    return m_rig.settle(method, frame, frames, {1, true, {}});
}

double compute_rms(const Image& a, const Image& b, const Image* mask) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        if (mask == nullptr || mask->values()[i] != 0.0f) {
            const double difference = a.values()[i] - b.values()[i];
            sum += difference * difference;
            count += 1.0;
        }
    }
    ALCOVE_ASSERT(count > 0.0, "pixels to compare");
    return std::sqrt(sum / count);
}

} // namespace alcove
