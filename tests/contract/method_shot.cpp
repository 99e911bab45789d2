#include "tests/contract/method_shot.hpp"

#include "core/contract/method_gbuffers.hpp"

namespace alcove {

Shot shoot(gl::Context& context, Method& method, const Scene& scene, const ShotSettings& settings) {
    constexpr std::uint32_t kSeed = 1;
    const gl::Functions& gl = context.functions();
    const MethodRequests requests = method.get_requests();
    SceneRenderer renderer(gl, scene);
    MethodGBuffers gbuffers(gl, renderer, scene, requests, settings.size, {});
    method.resize(settings.size);
    Shot shot;
    for (const int frame : settings.frames) {
        const FrameView view =
            make_frame_view(scene.get_walkthrough(), frame, settings.size, false);
        const PosedGeometry geometry = pose_geometry(scene, view.time_s);
        context.reset_state();
        gbuffers.draw(view);
        MethodInputs inputs = gbuffers.make_inputs();
        inputs.geometry = requests.posed_geometry ? &geometry : nullptr;
        const Lights lights = scene.compute_lights(view.time_s);
        inputs.lights = &lights;
        inputs.noise_seed = kSeed;
        inputs.wants_history_state = settings.wants_history_state;
        inputs.wants_visibility = true;
        if (settings.between != nullptr) {
            PassRecorder ignored(PassTiming::none);
            static_cast<void>(settings.between->render(inputs, ignored));
        }
        context.reset_state();
        PassRecorder recorder(PassTiming::none);
        const MethodOutput output = method.render(inputs, recorder);
        shot.passes = recorder.names();
        shot.visibility = gl::read_texture(gl, *output.visibility, 1);
        if (output.radiance != nullptr) {
            shot.radiance = gl::read_texture(gl, *output.radiance, 3);
        }
        if (output.history_state != nullptr) {
            shot.history_state = gl::read_texture(gl, *output.history_state, 4);
        }
        context.check_errors();
    }
    return shot;
}

} // namespace alcove
