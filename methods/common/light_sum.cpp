#include "methods/common/light_sum.hpp"

#include "methods/common/shaders.hpp"

#include <glm/gtc/type_ptr.hpp>

namespace alcove {

LightSum::LightSum(const gl::Functions& gl)
    : m_gl(gl), m_shade(gl, make_method_shader_library(), "methods/common/light_sum.frag.glsl"),
      m_nothing(gl, GL_RGBA16F, {1, 1}) {
    gl::write_texture(gl, m_nothing, Image({1, 1}, 4, 0.0f));
}

void LightSum::resize(ImageSize size) {
    m_size = size;
    m_arriving = gl::Texture(m_gl, GL_RGBA32F, size);
    m_arriving_framebuffer = gl::create_framebuffer(m_gl, {&m_arriving});
    m_radiance = gl::Texture(m_gl, GL_RGBA16F, size);
    m_radiance_framebuffer = gl::create_framebuffer(m_gl, {&m_radiance});
    m_open = {};
    m_visibility = {};
}

void LightSum::begin(bool wants_visibility) {
    m_keeps_open = wants_visibility;
    if (wants_visibility && !m_open) {
        m_open = gl::Texture(m_gl, GL_RGBA32F, m_size);
        m_both_framebuffer = gl::create_framebuffer(m_gl, {&m_arriving, &m_open});
        m_visibility = gl::Texture(m_gl, GL_R32F, m_size);
        m_visibility_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility});
    }
    constexpr std::array<float, 4> kZero{};
    m_gl.ClearNamedFramebufferfv(m_arriving_framebuffer.get(), GL_COLOR, 0, kZero.data());
    if (wants_visibility) {
        m_gl.ClearNamedFramebufferfv(m_both_framebuffer.get(), GL_COLOR, 1, kZero.data());
    }
}

void LightSum::add(const FullScreenProgram& program) const {
    m_gl.Enable(GL_BLEND);
    m_gl.BlendEquation(GL_FUNC_ADD);
    m_gl.BlendFunc(GL_ONE, GL_ONE);
    program.draw(m_keeps_open ? m_both_framebuffer.get() : m_arriving_framebuffer.get(), m_size);
    m_gl.BlendFunc(GL_ONE, GL_ZERO);
    m_gl.Disable(GL_BLEND);
}

void LightSum::draw(const MethodInputs& inputs, const LightSumSettings& settings,
                    bool shows_visibility, GLuint target) {
    m_shade.use();
    m_gl.BindTextureUnit(0, m_arriving.get());
    m_gl.BindTextureUnit(1, shows_visibility ? m_open.get() : m_nothing.get());
    m_gl.BindTextureUnit(2, inputs.gbuffer.texture(Channel::normal).get());
    m_gl.BindTextureUnit(3, inputs.gbuffer.texture(Channel::albedo).get());
    m_gl.BindTextureUnit(4, inputs.surroundings.prefiltered->get());
    m_gl.BindTextureUnit(5, settings.reflected != nullptr ? settings.reflected->get()
                                                          : m_nothing.get());
    m_gl.UniformMatrix3fv(m_shade.location("map_from_view"), 1, GL_FALSE,
                          glm::value_ptr(inputs.surroundings.map_from_view));
    const bool adds =
        shows_visibility ? settings.adds_surroundings_to_visibility : settings.adds_surroundings;
    m_gl.Uniform1i(m_shade.location("adds_surroundings"), adds ? 1 : 0);
    m_gl.Uniform1i(m_shade.location("adds_reflected"), settings.reflected != nullptr ? 1 : 0);
    m_gl.Uniform1i(m_shade.location("shows_visibility"), shows_visibility ? 1 : 0);
    m_shade.draw(target, m_size);
}

const gl::Texture& LightSum::shade(const MethodInputs& inputs, const LightSumSettings& settings) {
    draw(inputs, settings, false, m_radiance_framebuffer.get());
    return m_radiance;
}

const gl::Texture& LightSum::show_visibility(const MethodInputs& inputs,
                                             const LightSumSettings& settings) {
    ALCOVE_ASSERT(m_keeps_open, "light that nothing blocks");
    draw(inputs, settings, true, m_visibility_framebuffer.get());
    return m_visibility;
}

} // namespace alcove
