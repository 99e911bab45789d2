#include "methods/template_method/template_method.hpp"

#include "core/frame/full_screen.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/shaders.hpp"

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = TemplateMethodParams;
    return describe_parameters("template_method",
                               {
                                   real(&P::strength, "strength")
                                       .range(0.0, 1.0)
                                       .unit("1")
                                       .symbol("k")
                                       .meaning("Share of light that a surface seen edge-on loses.")
                                       .source("ours"),
                               });
}

class TemplateMethod final : public Method {
  public:
    TemplateMethod(const gl::Functions& gl, const ResolvedParameters& resolved)
        : m_gl(gl), m_parameters(gl, make_table(), resolved),
          m_program(gl, make_method_shader_library(),
                    "methods/template_method/template_method_shade.frag.glsl",
                    m_parameters.generated_files()) {
        m_parameters.connect(m_program.program());
    }

    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        m_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility});
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        const auto pass = passes.scope("template_method/shade");
        m_program.use();
        m_parameters.bind();
        m_gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
        m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
        m_program.draw(m_framebuffer.get(), inputs.view.size);
        return {&m_visibility, nullptr};
    }

  private:
    const gl::Functions& m_gl;
    ParameterBlock m_parameters;
    FullScreenProgram m_program;
    gl::Texture m_visibility;
    gl::FramebufferHandle m_framebuffer;
};

} // namespace

MethodUnit template_method_unit() {
    MethodUnit unit;
    unit.name = "template_method";
    unit.title = "Template: facing ratio";
    unit.citation = "nobody's work: copy this folder";
    unit.reported = false;
    unit.parameters = make_table();
    unit.presets = {{"default", "half strength", {}, 1.0, 2.0, ""}};
    unit.map_target = [](const Target&) {
        return TargetMapping{{}, "the facing ratio knows no radius"};
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<TemplateMethod>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
