#include "tests/harness/light_method.hpp"

namespace alcove {
namespace {

struct LightParams {
    double red = 0.5;
    bool gives_both = false;
    bool is_stubborn = false;
};

ParameterTable make_table() {
    return describe_parameters("light_method",
                               {real(&LightParams::red, "red")
                                    .range(0.0, 4.0)
                                    .unit("1")
                                    .meaning("Radiance.")
                                    .source("ours"),
                                boolean(&LightParams::gives_both, "gives_both")
                                    .meaning("Leaves visibility without being asked.")
                                    .source("ours"),
                                boolean(&LightParams::is_stubborn, "is_stubborn")
                                    .meaning("Leaves no visibility even when asked.")
                                    .source("ours")});
}

class LightMethod final : public Method {
  public:
    LightMethod(const gl::Functions& gl, const ResolvedParameters& resolved,
                std::shared_ptr<LightLog> log)
        : m_gl(gl), m_params(make_table().bind<LightParams>(resolved)), m_log(std::move(log)) {}

    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        m_radiance = gl::Texture(m_gl, GL_RGBA16F, size);
        gl::write_texture(m_gl, m_visibility, Image(size, 1, kLightVisibility));
        Image radiance(size, 3);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                radiance.at(x, y, 0) = static_cast<float>(m_params.red);
            }
        }
        gl::write_texture(m_gl, m_radiance, radiance);
    }
    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        const auto pass = passes.scope("light_method/shine");
        ++(inputs.wants_visibility ? m_log->asked : m_log->unasked);
        const bool leaves =
            (inputs.wants_visibility || m_params.gives_both) && !m_params.is_stubborn;
        return {leaves ? &m_visibility : nullptr, &m_radiance};
    }

  private:
    const gl::Functions& m_gl;
    LightParams m_params;
    std::shared_ptr<LightLog> m_log;
    gl::Texture m_visibility;
    gl::Texture m_radiance;
};

} // namespace

MethodUnit make_light_method_unit(std::shared_ptr<LightLog> log) {
    MethodUnit unit;
    unit.name = "light_method";
    unit.title = "The same light everywhere";
    unit.citation = "nobody's work: it shines";
    unit.content_hash = "none";
    unit.reported = false;
    unit.parameters = make_table();
    unit.presets = {{"default", "shines", {}, 1.0, 2.0, ""}};
    unit.map_target = [](const Target&) { return TargetMapping{{}, "it knows no radius"}; };
    unit.create = [log](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<LightMethod>(context.functions(), resolved, log);
    };
    return unit;
}

} // namespace alcove
