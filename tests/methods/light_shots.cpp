#include "tests/methods/light_shots.hpp"

#include "core/base/text.hpp"
#include "scenes/common/lighting.hpp"
#include "scenes/registry.hpp"

namespace alcove {
namespace {

std::vector<ParameterOverride> read_overrides(const std::string& settings) {
    std::vector<ParameterOverride> overrides;
    if (!settings.empty()) {
        for (const KeyValue& entry : parse_key_values(settings, "test")) {
            overrides.push_back({entry.key, entry.value, Provenance::command_line});
        }
    }
    return overrides;
}

} // namespace

LightShot LightShotTest::shoot(const MethodUnit& unit, const std::string& settings,
                               const Scene& scene, ImageSize size, int frame) {
    const ResolvedParameters resolved = unit.parameters.resolve(
        read_overrides(settings), {{"scene_radius", scene.get_ao_radius_m()}});
    const std::unique_ptr<Method> method = unit.create(context(), resolved);
    SceneRenderer renderer(gl(), scene);
    MethodGBuffers gbuffers(gl(), renderer, scene, method->get_requests(), size, {});
    method->resize(size);
    context().reset_state();
    gbuffers.draw(make_frame_view(scene.get_walkthrough(), frame, size, true));
    MethodInputs inputs = gbuffers.make_inputs();
    inputs.noise_seed = 1;
    inputs.wants_visibility = true;
    LightShot shot;
    {
        context().reset_state();
        PassRecorder recorder(PassTiming::none);
        const MethodOutput output = method->render(inputs, recorder);
        if (output.visibility != nullptr) {
            shot.visibility = gl::read_texture(gl(), *output.visibility, 1);
        }
    }
    inputs.wants_visibility = false;
    context().reset_state();
    PassRecorder recorder(PassTiming::none);
    const MethodOutput output = method->render(inputs, recorder);
    shot.radiance = gl::read_texture(gl(), *output.radiance, 3);
    shot.direct = gl::read_texture(gl(), inputs.gbuffer.texture(Channel::direct_light), 3);
    shot.albedo = gl::read_texture(gl(), inputs.gbuffer.texture(Channel::albedo), 3);
    shot.eye_depth = gl::read_texture(gl(), inputs.gbuffer.texture(Channel::eye_depth), 1);
    shot.normal = gl::read_texture(gl(), inputs.gbuffer.texture(Channel::normal), 3);
    shot.passes = recorder.names();
    context().check_errors();
    return shot;
}

std::unique_ptr<Scene> open_lit_scene(const std::string& name, const std::string& own,
                                      const std::string& lighting) {
    const SceneUnit unit = scenes_registry().find(name);
    Lighting light;
    light.params = lighting_table().bind<LightingParams>(
        lighting_table().resolve(read_overrides(lighting), {}));
    return relight(unit.open(unit.parameters.resolve(read_overrides(own), {})), light);
}

} // namespace alcove
