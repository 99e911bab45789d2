#include "tests/contract/hostile_method.hpp"

namespace alcove {
namespace {

class HostileMethod final : public Method {
  public:
    explicit HostileMethod(const gl::Functions& gl) : m_gl(gl) {}

    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        m_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility});
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        const auto pass = passes.scope("hostile/dirty");
        m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.get());
        m_gl.Viewport(3, 5, 7, 11);
        m_gl.Enable(GL_BLEND);
        m_gl.BlendEquation(GL_FUNC_REVERSE_SUBTRACT);
        m_gl.BlendFunc(GL_ZERO, GL_ZERO);
        m_gl.Enable(GL_DEPTH_TEST);
        m_gl.Enable(GL_CULL_FACE);
        m_gl.Enable(GL_SCISSOR_TEST);
        m_gl.CullFace(GL_FRONT_AND_BACK);
        m_gl.FrontFace(GL_CW);
        m_gl.DepthFunc(GL_NEVER);
        m_gl.DepthMask(GL_FALSE);
        m_gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        m_gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
        m_gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
        m_gl.PixelStorei(GL_PACK_ALIGNMENT, 8);
        m_gl.PixelStorei(GL_UNPACK_ALIGNMENT, 8);
        for (GLuint unit = 0; unit < 8; ++unit) {
            m_gl.BindTextureUnit(unit, m_visibility.get());
        }
        static_cast<void>(inputs);
        return {&m_visibility, nullptr};
    }

  private:
    const gl::Functions& m_gl;
    gl::Texture m_visibility;
    gl::FramebufferHandle m_framebuffer;
};

} // namespace

std::unique_ptr<Method> make_hostile_method(const gl::Functions& gl) {
    return std::make_unique<HostileMethod>(gl);
}

} // namespace alcove
