#include "tests/methods/tssao_rig.hpp"

#include "core/base/text.hpp"

namespace alcove {

void TssaoTest::make(ImageSize size, const std::string& settings, const std::string& preset) {
    const MethodUnit unit = tssao_unit();
    std::vector<ParameterOverride> overrides = unit.find_preset(preset).overrides;
    if (!settings.empty()) {
        for (const KeyValue& entry : parse_key_values(settings, "settings")) {
            overrides.push_back({entry.key, entry.value});
        }
    }
    const ResolvedParameters resolved = unit.parameters.resolve(overrides, {{"scene_radius", 0.5}});
    m_params = unit.parameters.bind<TssaoParams>(resolved);
    m_size = size;
    m_method = std::make_unique<TssaoRenderer>(gl(), resolved);
    m_method->resize(size);
    m_gbuffer.emplace(gl(), size, ChannelSet{Channel::eye_depth, Channel::normal, Channel::motion},
                      Precision{});
    m_previous_camera.reset();
    m_frame = 0;
}

TssaoFrame TssaoTest::render(const DepthImage& image, const Image* motion) {
    gl::write_texture(gl(), m_gbuffer->texture(Channel::eye_depth), image.depth);
    gl::write_texture(gl(), m_gbuffer->texture(Channel::normal), image.normal);
    gl::write_texture(gl(), m_gbuffer->texture(Channel::motion),
                      motion != nullptr ? *motion : Image(m_size, 3));
    FrameView view;
    view.index = m_frame++;
    view.size = m_size;
    view.camera = image.camera;
    view.previous_camera = m_previous_camera.value_or(image.camera);
    view.history_valid = m_previous_camera.has_value();
    view.objects_may_move = motion != nullptr;
    m_previous_camera = image.camera;
    MethodInputs inputs{view, *m_gbuffer};
    inputs.noise_seed = 1;
    inputs.wants_history_state = true;
    PassRecorder passes(PassTiming::none);
    context().reset_state();
    const MethodOutput output = m_method->render(inputs, passes);
    TssaoFrame frame;
    frame.visibility = gl::read_texture(gl(), *output.visibility, 1);
    frame.history = gl::read_texture(gl(), m_method->history(), 4);
    if (output.history_state != nullptr) {
        frame.state = gl::read_texture(gl(), *output.history_state, 4);
    }
    frame.passes = passes.names();
    context().check_errors();
    return frame;
}

void TssaoTest::plant(int x, int y, const std::array<float, 4>& values) {
    Image history = gl::read_texture(gl(), m_method->history(), 4);
    for (int c = 0; c < 4; ++c) {
        history.at(x, y, c) = values.at(static_cast<std::size_t>(c));
    }
    gl::write_texture(gl(), m_method->history(), history);
}

} // namespace alcove
