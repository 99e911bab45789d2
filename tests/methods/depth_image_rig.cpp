#include "tests/methods/depth_image_rig.hpp"

namespace alcove {

DepthImage make_wall_image(ImageSize size, float depth_m) {
    DepthImage image{Image(size, 1, depth_m), Image(size, 3), {}};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            image.normal.at(x, y, 2) = 1.0f;
        }
    }
    return image;
}

RigResult DepthImageTest::run(const MethodUnit& unit, const ResolvedParameters& resolved,
                              const DepthImage& input, std::uint32_t noise_seed) {
    const ImageSize size = input.depth.size();
    const GBuffer gbuffer(gl(), size, {Channel::eye_depth, Channel::normal}, {});
    gl::write_texture(gl(), gbuffer.texture(Channel::eye_depth), input.depth);
    gl::write_texture(gl(), gbuffer.texture(Channel::normal), input.normal);
    const std::unique_ptr<Method> method = unit.create(context(), resolved);
    method->resize(size);
    FrameView view;
    view.camera = input.camera;
    view.previous_camera = input.camera;
    view.size = size;
    PassRecorder passes(PassTiming::none);
    context().reset_state();
    MethodInputs inputs{view, gbuffer};
    inputs.noise_seed = noise_seed;
    const MethodOutput output = method->render(inputs, passes);
    return {gl::read_texture(gl(), *output.visibility, 1),
            gl::read_texture(gl(), gbuffer.texture(Channel::normal), 3), passes.names()};
}

ResolvedParameters
DepthImageTest::resolve(const MethodUnit& unit, const std::string& preset,
                        const std::vector<std::pair<std::string, std::string>>& overrides) {
    std::vector<ParameterOverride> all = unit.find_preset(preset).overrides;
    for (const auto& [name, value] : overrides) {
        all.push_back({name, value, Provenance::command_line});
    }
    return unit.parameters.resolve(all, {{"scene_radius", 0.5}});
}

} // namespace alcove
