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

const GBuffer& SceneRig::draw(ChannelSet channels, const FrameView& view,
                              const Precision& precision) {
    m_context.reset_state();
    for (const std::unique_ptr<Buffer>& buffer : m_buffers) {
        if (buffer->channels == channels && buffer->size == view.size &&
            buffer->precision == precision) {
            m_renderer.render(buffer->gbuffer, view);
            return buffer->gbuffer;
        }
    }
    m_buffers.push_back(std::make_unique<Buffer>(
        Buffer{channels, view.size, precision,
               GBuffer(m_context.functions(), view.size, channels, precision)}));
    m_renderer.render(m_buffers.back()->gbuffer, view);
    return m_buffers.back()->gbuffer;
}

RigShot SceneRig::shoot(Method& method, const FrameView& view, const ShotOptions& options) {
    const MethodRequests requests = method.get_requests();
    const Border border = make_border(m_size, requests.border);
    const FrameView extended = extend(view, border);
    const GBuffer& gbuffer = draw(kBaseChannels | requests.channels, extended, m_precision);
    if (options.edit) {
        options.edit(gbuffer, border);
    }
    std::optional<PosedGeometry> geometry;
    if (requests.posed_geometry) {
        geometry = pose_geometry(m_scene, view.time_s);
    }
    // Geometry is traced through the view that it is asked for; textures carry the border.
    MethodInputs inputs{extended, gbuffer};
    inputs.geometry = geometry ? &*geometry : nullptr;
    inputs.lights = &m_scene.get_lights();
    inputs.noise_seed = options.seed;
    inputs.wants_history_state = options.wants_history_state;
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
    const GBuffer& gbuffer = draw({Channel::eye_depth}, view, {});
    return gl::read_texture(m_context.functions(), gbuffer.texture(Channel::eye_depth), 1);
}

} // namespace alcove
