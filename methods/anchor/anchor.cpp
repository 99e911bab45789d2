#include "methods/anchor/anchor.hpp"

#include "core/frame/full_screen.hpp"
#include "methods/common/shaders.hpp"

namespace alcove {
namespace {

class Anchor final : public Method {
  public:
    explicit Anchor(const gl::Functions& gl)
        : m_gl(gl), m_program(gl, make_method_shader_library(), "methods/anchor/anchor.frag.glsl") {
    }

    MethodRequests get_requests() const override { return {{Channel::eye_depth}, false}; }

    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        m_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility});
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        const auto pass = passes.scope("anchor/fetch");
        m_program.use();
        m_gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
        m_program.draw(m_framebuffer.get(), inputs.view.size);
        return {&m_visibility, nullptr};
    }

  private:
    const gl::Functions& m_gl;
    FullScreenProgram m_program;
    gl::Texture m_visibility;
    gl::FramebufferHandle m_framebuffer;
};

} // namespace

MethodUnit anchor_unit() {
    MethodUnit unit;
    unit.name = "anchor";
    unit.title = "Anchor: 32 depth fetches";
    unit.citation = "Alcove's own yardstick";
    unit.reported = false;
    unit.parameters = describe_parameters("anchor", {});
    unit.presets = {{"default", "the only one", {}, 1.0, 2.0, ""}};
    unit.map_target = [](const Target&) {
        return TargetMapping{{}, "the anchor is no estimate of occlusion"};
    };
    unit.create = [](gl::Context& context, const ResolvedParameters&) {
        return std::make_unique<Anchor>(context.functions());
    };
    return unit;
}

} // namespace alcove
