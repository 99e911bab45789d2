#include "methods/statvo/statvo_renderer.hpp"

#include "methods/common/shaders.hpp"

namespace alcove {
namespace {

constexpr GLuint kOcclusionUnit = 2;
constexpr GLuint kSamplesUnit = kStatvoTablesUnit + kStatvoBatch;

} // namespace

StatvoRenderer::StatvoRenderer(const gl::Functions& gl, const ResolvedParameters& resolved)
    : m_gl(gl), m_params(make_statvo_table().bind<StatvoParams>(resolved)),
      m_parameters(gl, make_statvo_table(), resolved), m_tables(gl, m_params, m_parameters) {
    gl::GeneratedFiles files = m_tables.make_generated_files(m_tables.count_nodes());
    if (m_params.layering == StatvoLayering::uniform) {
        files["summed_area_format.glsl"] += "#define ACCUMULATES\n";
        m_resolve = FullScreenProgram(gl, make_method_shader_library(),
                                      "methods/statvo/statvo_resolve.frag.glsl", files);
        m_parameters.connect(m_resolve.program());
    }
    m_evaluate = FullScreenProgram(gl, make_method_shader_library(),
                                   "methods/statvo/statvo_evaluate.frag.glsl", files);
    m_parameters.connect(m_evaluate.program());
}

MethodRequests StatvoRenderer::get_requests() const {
    MethodRequests requests;
    requests.border = m_params.guard / 100.0;
    if (m_params.source == StatvoSource::peeled) {
        requests.layers = 2;
        requests.part_channels = ChannelSet{Channel::eye_depth};
    }
    return requests;
}

void StatvoRenderer::resize(ImageSize size) {
    m_size = size;
    const Border border = make_border(size, get_requests().border);
    m_tables.resize({size.width + 2 * border.x, size.height + 2 * border.y});
    m_visibility = gl::Texture(m_gl, GL_R32F, size);
    m_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility});
    if (m_params.layering == StatvoLayering::uniform) {
        for (Sums& sums : m_sums) {
            sums.occlusion = gl::Texture(m_gl, GL_RGBA32F, size);
            sums.samples = gl::Texture(m_gl, GL_RGBA32F, size);
            sums.framebuffer = gl::create_framebuffer(m_gl, {&sums.occlusion, &sums.samples});
        }
    }
}

MethodOutput StatvoRenderer::render(const MethodInputs& inputs, PassRecorder& passes) {
    m_tables.render_samples(inputs, passes);
    if (m_params.layering == StatvoLayering::adaptive) {
        m_tables.build_levels(passes);
        const auto pass = passes.scope("statvo/evaluate");
        m_evaluate.use();
        evaluate(inputs, m_framebuffer.get());
    } else {
        evaluate_slices(inputs, passes);
    }
    return {&m_visibility, nullptr};
}

/// m_evaluate must be current.
void StatvoRenderer::evaluate(const MethodInputs& inputs, GLuint framebuffer) {
    const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
    const Border border = make_border(m_size, get_requests().border);
    m_parameters.bind();
    m_tables.bind();
    m_gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
    m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
    m_gl.Uniform2f(m_evaluate.location("tangents"), tangents.x, tangents.y);
    m_gl.Uniform2i(m_evaluate.location("border"), border.x, border.y);
    m_evaluate.draw(framebuffer, m_size);
}

void StatvoRenderer::evaluate_slices(const MethodInputs& inputs, PassRecorder& passes) {
    m_tables.assign_slices(passes);
    std::size_t current = 0;
    for (int batch = 0; batch * kStatvoBatch < m_params.slices; ++batch) {
        const int count = m_tables.build_slices(batch, passes);
        const auto pass = passes.scope("statvo/evaluate" + std::to_string(batch + 1));
        m_evaluate.use();
        m_gl.Uniform1i(m_evaluate.location("batch"), count);
        m_gl.Uniform1i(m_evaluate.location("is_first"), batch == 0 ? 1 : 0);
        m_gl.BindTextureUnit(kOcclusionUnit, m_sums[current].occlusion.get());
        m_gl.BindTextureUnit(kSamplesUnit, m_sums[current].samples.get());
        current = 1 - current;
        evaluate(inputs, m_sums[current].framebuffer.get());
    }
    const auto pass = passes.scope("statvo/resolve");
    m_resolve.use();
    m_parameters.bind();
    m_gl.BindTextureUnit(0, m_sums[current].occlusion.get());
    m_gl.BindTextureUnit(1, m_sums[current].samples.get());
    m_resolve.draw(m_framebuffer.get(), m_size);
}

} // namespace alcove
