#include "methods/common/tile_blur.hpp"

#include "methods/common/shaders.hpp"

namespace alcove {
namespace {

/// What the last direction leaves: the incoming radiance itself, or times albedo.
constexpr int kKeep = 0;
constexpr int kShade = 1;
constexpr int kShow = 2;

} // namespace

TileBlur::TileBlur(const gl::Functions& gl)
    : m_gl(&gl), m_program(gl, make_method_shader_library(), "methods/common/tile_blur.frag.glsl") {
}

void TileBlur::resize(ImageSize size) {
    m_intermediate = gl::Texture(*m_gl, GL_RGBA32F, size);
    m_intermediate_framebuffer = gl::create_framebuffer(*m_gl, {&m_intermediate});
}

void TileBlur::draw(const MethodInputs& inputs, const TileBlurSettings& settings,
                    const gl::Texture& source, GLuint target, bool is_along_x, int finish) const {
    m_program.use();
    m_gl->BindTextureUnit(0, source.get());
    m_gl->BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
    m_gl->BindTextureUnit(2, inputs.gbuffer.texture(Channel::albedo).get());
    const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
    m_gl->Uniform2f(m_program.location("tangents"), tangents.x, tangents.y);
    m_gl->Uniform2i(m_program.location("direction"), is_along_x ? 1 : 0, is_along_x ? 0 : 1);
    m_gl->Uniform1i(m_program.location("tile"), settings.tile);
    m_gl->Uniform1i(m_program.location("finish"), finish);
    m_gl->Uniform1f(m_program.location("edge_distance"),
                    static_cast<float>(settings.edge_distance_m));
    m_program.draw(target, inputs.view.size);
}

void TileBlur::render(const MethodInputs& inputs, const TileBlurSettings& settings,
                      const gl::Texture& incoming, GLuint target, bool is_shaded,
                      const std::string& owner, PassRecorder& passes) const {
    const int finish = is_shaded ? kShade : kShow;
    if (settings.tile == 1) {
        const auto pass = passes.scope(owner + "/shade");
        draw(inputs, settings, incoming, target, true, finish);
        return;
    }
    {
        const auto pass = passes.scope(owner + "/blur_x");
        draw(inputs, settings, incoming, m_intermediate_framebuffer.get(), true, kKeep);
    }
    const auto pass = passes.scope(owner + "/blur_y");
    draw(inputs, settings, m_intermediate, target, false, finish);
}

} // namespace alcove
