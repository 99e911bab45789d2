#include "harness/stability/scene_rig.hpp"

namespace alcove {

SceneRig::SceneRig(gl::Context& context, const Scene& scene, ImageSize size,
                   const Precision& precision)
    : m_context(context), m_scene(scene), m_size(size), m_precision(precision),
      m_renderer(context.functions(), scene) {}

FrameView SceneRig::get_view(int frame, bool starts_segment) const {
    FrameView view = make_frame_view(m_scene.get_walkthrough(), frame, m_size, starts_segment);
    detect_motion(m_scene, view);
    return view;
}

MethodGBuffers& SceneRig::find_gbuffers(const MethodRequests& requests) {
    for (const Buffers& buffers : m_buffers) {
        if (buffers.requests == requests) {
            return *buffers.gbuffers;
        }
    }
    m_buffers.push_back(
        {requests, std::make_unique<MethodGBuffers>(m_context.functions(), m_renderer, m_scene,
                                                    requests, m_size, m_precision)});
    return *m_buffers.back().gbuffers;
}

RigShot SceneRig::shoot(Method& method, const FrameView& view, const ShotOptions& options) {
    const MethodRequests requests = method.get_requests();
    MethodGBuffers& gbuffers = find_gbuffers(requests);
    m_context.reset_state();
    gbuffers.draw(view);
    if (options.edit) {
        options.edit(gbuffers.main(), gbuffers.border());
    }
    std::optional<PosedGeometry> geometry;
    if (requests.posed_geometry) {
        geometry = pose_geometry(m_scene, view.time_s);
    }
    MethodInputs inputs = gbuffers.make_inputs();
    inputs.geometry = geometry ? &*geometry : nullptr;
    const Lights lights = m_scene.compute_lights(view.time_s);
    inputs.lights = &lights;
    inputs.noise_seed = options.seed;
    inputs.wants_history_state = options.wants_history_state;
    inputs.wants_visibility = true;
    PassRecorder passes(PassTiming::none);
    m_context.reset_state();
    const MethodOutput output = method.render(inputs, passes);
    ALCOVE_ASSERT(output.visibility != nullptr, "a method that leaves a visibility");
    const gl::Functions& gl = m_context.functions();
    RigShot shot;
    shot.visibility = gl::read_texture(gl, *output.visibility, 1);
    if (output.history_state != nullptr) {
        shot.history_state = gl::read_texture(gl, *output.history_state, 4);
    }
    shot.passes = passes.names();
    m_context.check_errors();
    return shot;
}

RigShot SceneRig::settle(Method& method, int frame, int frames, const ShotOptions& options) {
    ALCOVE_ASSERT(frames >= 1, "a frame");
    method.reset_history();
    const FrameView first = get_view(frame, true);
    RigShot shot = shoot(method, first, options);
    for (int i = 1; i < frames; ++i) {
        const FrameView held = hold(first);
        shot = shoot(method, held, options);
    }
    return shot;
}

Image SceneRig::read_depth(const FrameView& view) {
    if (!m_depth || !(m_depth->size() == view.size)) {
        m_depth.emplace(m_context.functions(), view.size, ChannelSet{Channel::eye_depth},
                        Precision{});
    }
    m_context.reset_state();
    m_renderer.render(*m_depth, view);
    return gl::read_texture(m_context.functions(), m_depth->texture(Channel::eye_depth), 1);
}

} // namespace alcove
