#include "core/frame/compose.hpp"

#include "core/gl/shaders.hpp"

#include <algorithm>

#include <glm/gtc/type_ptr.hpp>

namespace alcove {

Compose::Compose(const gl::Functions& gl, ImageSize size)
    : m_gl(gl), m_picture(gl, GL_RGBA16F, size),
      m_framebuffer(gl::create_framebuffer(gl, {&m_picture})),
      m_program(gl, gl::ShaderLibrary{embedded_frame_shaders(), embedded_gl_shaders()},
                "core/frame/compose.frag.glsl") {}

void Compose::render(const GBuffer& gbuffer, const SurroundingsView& surroundings,
                     const Camera& camera, const ComposedImages& images, PassRecorder& passes,
                     const gl::Texture* pixel_depth) {
    ALCOVE_ASSERT((images.visibility != nullptr) != (images.radiance != nullptr),
                  "a visibility or a radiance image");
    const bool is_multisampled = gbuffer.samples() > 1;
    ALCOVE_ASSERT(pixel_depth == nullptr || is_multisampled, "depths that samples choose by");
    if (is_multisampled && !m_multisampled) {
        m_multisampled.emplace(m_gl,
                               gl::ShaderLibrary{embedded_frame_shaders(), embedded_gl_shaders()},
                               "core/frame/compose_multisampled.frag.glsl");
    }
    const FullScreenProgram& program = is_multisampled ? *m_multisampled : m_program;
    const auto pass = passes.scope("harness/compose");
    program.use();
    m_gl.BindTextureUnit(0, gbuffer.texture(Channel::eye_depth).get());
    m_gl.BindTextureUnit(1, gbuffer.texture(Channel::albedo).get());
    m_gl.BindTextureUnit(2, gbuffer.texture(Channel::direct_light).get());
    m_gl.BindTextureUnit(
        3, (images.visibility != nullptr ? images.visibility : images.radiance)->get());
    if (pixel_depth != nullptr) {
        m_gl.BindTextureUnit(4, pixel_depth->get());
    }
    m_gl.Uniform1i(program.location("samples"), gbuffer.samples());
    m_gl.Uniform1i(program.location("takes_nearest"), pixel_depth != nullptr ? 1 : 0);
    m_gl.Uniform1i(program.location("is_radiance"), images.radiance != nullptr ? 1 : 0);
    m_gl.Uniform1i(program.location("adds_direct_light"), images.replaces_direct_light ? 0 : 1);
    m_gl.BindTextureUnit(5, gbuffer.texture(Channel::normal).get());
    m_gl.BindTextureUnit(6, surroundings.radiance->get());
    m_gl.BindTextureUnit(7, surroundings.prefiltered->get());
    m_gl.UniformMatrix3fv(program.location("map_from_view"), 1, GL_FALSE,
                          glm::value_ptr(surroundings.map_from_view));
    const glm::vec2 tangents(compute_tangents(camera, m_picture.size()));
    m_gl.Uniform2f(program.location("tangents"), tangents.x, tangents.y);
    program.draw(m_framebuffer.get(), m_picture.size());
}

Image tone_map(const Image& radiance) {
    Image mapped = radiance;
    for (float& value : mapped.values()) {
        const float x = std::max(value, 0.0f);
        value = std::min(x * (1.0f + x / 16.0f) / (1.0f + x), 1.0f);
    }
    return mapped;
}

} // namespace alcove
