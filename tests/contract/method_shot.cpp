#include "tests/contract/method_shot.hpp"

#include "core/frame/scene_renderer.hpp"

namespace alcove {

Shot shoot(gl::Context& context, Method& method, const Scene& scene, const ShotSettings& settings) {
    constexpr std::uint32_t kSeed = 1;
    const gl::Functions& gl = context.functions();
    const MethodRequests requests = method.get_requests();
    const GBuffer gbuffer(gl, settings.size, kBaseChannels | requests.channels, {});
    SceneRenderer renderer(gl, scene);
    const PosedGeometry geometry = pose_geometry(scene, 0.0);
    method.resize(settings.size);
    Shot shot;
    for (const int frame : settings.frames) {
        const FrameView view =
            make_frame_view(scene.get_walkthrough(), frame, settings.size, false);
        context.reset_state();
        renderer.render(gbuffer, view);
        MethodInputs inputs{view, gbuffer};
        inputs.geometry = requests.posed_geometry ? &geometry : nullptr;
        inputs.lights = &scene.get_lights();
        inputs.noise_seed = kSeed;
        if (settings.between != nullptr) {
            PassRecorder ignored(PassTiming::none);
            static_cast<void>(settings.between->render(inputs, ignored));
        }
        context.reset_state();
        PassRecorder recorder(PassTiming::none);
        const MethodOutput output = method.render(inputs, recorder);
        shot.passes = recorder.names();
        shot.visibility = gl::read_texture(gl, *output.visibility, 1);
        context.check_errors();
    }
    return shot;
}

} // namespace alcove
