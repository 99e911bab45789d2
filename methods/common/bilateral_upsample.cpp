#include "methods/common/bilateral_upsample.hpp"

#include "methods/common/shaders.hpp"

namespace alcove {

BilateralUpsample::BilateralUpsample(const gl::Functions& gl)
    : m_gl(&gl),
      m_select(gl, make_method_shader_library(), "methods/common/half_resolution_select.frag.glsl"),
      m_upsample(gl, make_method_shader_library(), "methods/common/bilateral_upsample.frag.glsl") {}

void BilateralUpsample::resize(ImageSize full) {
    const ImageSize half{(full.width + 1) / 2, (full.height + 1) / 2};
    m_selection = gl::Texture(*m_gl, GL_RG32F, half);
    m_selection_framebuffer = gl::create_framebuffer(*m_gl, {&m_selection});
}

void BilateralUpsample::select(const MethodInputs& inputs, const std::string& owner,
                               PassRecorder& passes) const {
    const auto pass = passes.scope(owner + "/downsample");
    m_select.use();
    m_gl->BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
    m_select.draw(m_selection_framebuffer.get(), half_size());
}

void BilateralUpsample::render(const MethodInputs& inputs,
                               const BilateralUpsampleSettings& settings,
                               const gl::Texture& half_visibility, GLuint full_framebuffer,
                               const std::string& owner, PassRecorder& passes) const {
    ALCOVE_ASSERT(half_visibility.size() == half_size(), "a visibility of half the size");
    ALCOVE_ASSERT(settings.width >= 2 && settings.width <= 32, "a window of 2 to 32 pixels");
    const auto pass = passes.scope(owner + "/upsample");
    const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
    m_upsample.use();
    m_gl->BindTextureUnit(0, half_visibility.get());
    m_gl->BindTextureUnit(1, m_selection.get());
    m_gl->BindTextureUnit(2, inputs.gbuffer.texture(Channel::eye_depth).get());
    m_gl->BindTextureUnit(3, inputs.gbuffer.texture(Channel::normal).get());
    m_gl->Uniform1i(m_upsample.location("width"), settings.width);
    m_gl->Uniform1f(m_upsample.location("edge_distance"),
                    static_cast<float>(settings.edge_distance_m));
    m_gl->Uniform2f(m_upsample.location("tangents"), tangents.x, tangents.y);
    m_upsample.draw(full_framebuffer, inputs.view.size);
}

} // namespace alcove
