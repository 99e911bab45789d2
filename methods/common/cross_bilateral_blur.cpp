#include "methods/common/cross_bilateral_blur.hpp"

#include "methods/common/shaders.hpp"

namespace alcove {

CrossBilateralBlur::CrossBilateralBlur(const gl::Functions& gl)
    : m_gl(&gl),
      m_program(gl, make_method_shader_library(), "methods/common/cross_bilateral_blur.frag.glsl") {
}

void CrossBilateralBlur::resize(ImageSize size) {
    m_intermediate = gl::Texture(*m_gl, GL_R32F, size);
    m_intermediate_framebuffer = gl::create_framebuffer(*m_gl, {&m_intermediate});
}

void CrossBilateralBlur::render(const MethodInputs& inputs,
                                const CrossBilateralBlurSettings& settings,
                                const gl::Texture& visibility, GLuint visibility_framebuffer,
                                const std::string& owner, PassRecorder& passes) const {
    const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
    const auto run = [&](const char* name, GLint x, GLint y, const gl::Texture& from, GLuint into) {
        const auto pass = passes.scope(owner + name);
        m_program.use();
        m_gl->BindTextureUnit(0, from.get());
        m_gl->BindTextureUnit(1, inputs.gbuffer.texture(Channel::eye_depth).get());
        m_gl->BindTextureUnit(2, inputs.gbuffer.texture(Channel::normal).get());
        m_gl->Uniform2i(m_program.location("direction"), x, y);
        m_gl->Uniform1i(m_program.location("radius"), settings.radius);
        m_gl->Uniform1f(m_program.location("edge_distance"),
                        static_cast<float>(settings.edge_distance_m));
        m_gl->Uniform2f(m_program.location("tangents"), tangents.x, tangents.y);
        m_program.draw(into, inputs.view.size);
    };
    run("/blur_x", 1, 0, visibility, m_intermediate_framebuffer.get());
    run("/blur_y", 0, 1, m_intermediate, visibility_framebuffer);
}

} // namespace alcove
