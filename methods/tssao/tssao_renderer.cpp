#include "methods/tssao/tssao_renderer.hpp"

#include "core/frame/reprojection.hpp"
#include "methods/common/shaders.hpp"

#include <algorithm>
#include <cctype>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

constexpr GLuint kKernelBinding = 1;

/// Full-screen triangles lie at depth 0.5: the filter's depth test lets them pass where the mask is
/// less.
constexpr const char* kVariantConstants = "#define DEPTH_UNCONVERGED 0.25\n"
                                          "#define DEPTH_CONVERGED 0.75\n";

const char* to_glsl(bool value) {
    return value ? "true" : "false";
}

} // namespace

/// Facts that host and shaders share.
gl::GeneratedFiles TssaoRenderer::make_generated_files(bool objects_may_move,
                                                       bool writes_state) const {
    std::string text = kVariantConstants;
    text += "#define KERNEL_LENGTH " + std::to_string(kTssaoKernelLength) + "\n";
    text += "#define LARGEST_PUBLISHED_CAP " + std::to_string(kTssaoLargestPublishedCap) + "\n";
    for (std::size_t i = 0; i < kHistoryCauseNames.size(); ++i) {
        std::string name(kHistoryCauseNames.at(i));
        std::transform(name.begin(), name.end(), name.begin(),
                       [](char c) { return static_cast<char>(std::toupper(c)); });
        text += "#define HISTORY_" + name + " " + std::to_string(i) + "\n";
    }
    text += std::string("#define OBJECTS_MAY_MOVE ") + to_glsl(objects_may_move) + "\n";
    text += std::string("#define READS_MOTION ") +
            to_glsl(m_effects.contains(Effect::object_motion)) + "\n";
    text += std::string("#define REPROJECTS ") + to_glsl(m_effects.contains(Effect::reprojection)) +
            "\n";
    text += std::string("#define IS_PACKED ") + to_glsl(is_packed()) + "\n";
    text += writes_state ? "#define WRITE_HISTORY_STATE\n" : "";
    gl::GeneratedFiles files = m_parameters.generated_files();
    files["variant.glsl"] = std::move(text);
    return files;
}

TssaoRenderer::TssaoRenderer(const gl::Functions& gl, const ResolvedParameters& resolved)
    : m_gl(gl), m_params(make_tssao_table().bind<TssaoParams>(resolved)),
      m_parameters(gl, make_tssao_table(), resolved) {
    const bool is_hemisphere = m_params.estimator == TssaoEstimator::hemisphere;
    const std::vector<glm::vec4> kernel =
        is_hemisphere ? make_hemisphere_kernel(kTssaoKernelLength, m_params.directions)
                      : make_disc_kernel(kTssaoKernelLength);
    m_kernel = gl::create_buffer(gl, std::as_bytes(std::span(kernel)));
    if (m_params.filter_radius > 0) {
        m_filter = FullScreenProgram(gl, make_method_shader_library(),
                                     "methods/tssao/tssao_filter.frag.glsl",
                                     make_generated_files(true, false));
        m_parameters.connect(m_filter.program());
    }
}

void TssaoRenderer::set_effects(EffectSet effects) {
    ALCOVE_ASSERT(m_accumulate.front().program().get() == 0, "before the first size");
    m_effects = effects;
}

bool TssaoRenderer::is_packed() const {
    return m_params.packing == TssaoPacking::packed && m_effects.contains(Effect::object_motion);
}

MethodRequests TssaoRenderer::get_requests() const {
    MethodRequests requests;
    if (is_packed()) {
        requests.channels.add(Channel::motion_depth);
    } else if (m_params.use_history && m_effects.contains(Effect::object_motion)) {
        requests.channels.add(Channel::motion);
    }
    requests.border = m_params.guard / 100.0;
    return requests;
}

void TssaoRenderer::resize(ImageSize size) {
    // Those that timed replays use; the parameters are fixed, the effects are known by now.
    static_cast<void>(get_accumulate_program(false, false));
    if (m_effects.contains(Effect::object_motion)) {
        static_cast<void>(get_accumulate_program(true, false));
    }
    const bool resolves = m_params.resolution == TssaoResolution::half || m_params.guard > 0.0;
    if (resolves && m_resolve.program().get() == 0) {
        m_resolve = FullScreenProgram(m_gl, make_method_shader_library(),
                                      "methods/tssao/tssao_resolve.frag.glsl",
                                      make_generated_files(false, false));
        m_parameters.connect(m_resolve.program());
    }
    m_size = size;
    const Border border = make_border(size, get_requests().border);
    const int scale = m_params.resolution == TssaoResolution::half ? 2 : 1;
    m_work_size = {(size.width + 2 * border.x + scale - 1) / scale,
                   (size.height + 2 * border.y + scale - 1) / scale};
    m_visibility = gl::Texture(m_gl, GL_R32F, m_work_size);
    m_mask = gl::Texture(m_gl, GL_DEPTH_COMPONENT32F, m_work_size);
    m_visibility_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility}, &m_mask);
    m_state = gl::Texture();
    for (HistoryBuffer& buffer : m_buffers) {
        buffer.history = gl::Texture(m_gl, GL_RGBA32F, m_work_size);
        buffer.framebuffer =
            gl::create_framebuffer(m_gl, {&buffer.history, &m_visibility}, &m_mask);
        buffer.state_framebuffer = gl::FramebufferHandle();
    }
    if (m_params.filter_radius > 0) {
        m_first = gl::Texture(m_gl, GL_R32F, m_work_size);
        m_first_framebuffer = gl::create_framebuffer(m_gl, {&m_first}, &m_mask);
    }
    if (resolves) {
        m_resolved = gl::Texture(m_gl, GL_R32F, size);
        m_resolved_framebuffer = gl::create_framebuffer(m_gl, {&m_resolved});
    }
    reset_history();
}

const gl::Texture& TssaoRenderer::get_depth(const MethodInputs& inputs) const {
    return inputs.gbuffer.texture(is_packed() ? Channel::motion_depth : Channel::eye_depth);
}

const FullScreenProgram& TssaoRenderer::get_accumulate_program(bool objects_may_move,
                                                               bool writes_state) {
    FullScreenProgram& program =
        m_accumulate.at((objects_may_move ? 1u : 0u) + (writes_state ? 2u : 0u));
    if (program.program().get() == 0) {
        program = FullScreenProgram(m_gl, make_method_shader_library(),
                                    "methods/tssao/tssao_accumulate.frag.glsl",
                                    make_generated_files(objects_may_move, writes_state));
        m_parameters.connect(program.program());
        program.program().bind_block("KernelBlock", kKernelBinding);
    }
    return program;
}

void TssaoRenderer::allocate_state() {
    if (m_state) {
        return;
    }
    m_state = gl::Texture(m_gl, GL_RGBA32F, m_work_size);
    for (HistoryBuffer& buffer : m_buffers) {
        buffer.state_framebuffer =
            gl::create_framebuffer(m_gl, {&buffer.history, &m_visibility, &m_state}, &m_mask);
    }
}

void TssaoRenderer::accumulate(const MethodInputs& inputs, PassRecorder& passes) {
    const bool objects_may_move =
        inputs.view.objects_may_move && m_effects.contains(Effect::object_motion);
    const FullScreenProgram& program =
        get_accumulate_program(objects_may_move, inputs.wants_history_state);
    if (inputs.wants_history_state) {
        allocate_state();
    }
    const auto pass = passes.scope("tssao/accumulate");
    const FrameView& view = inputs.view;
    const HistoryBuffer& old = m_buffers.at(m_latest);
    m_latest = 1 - m_latest;
    const HistoryBuffer& fresh = m_buffers.at(m_latest);
    program.use();
    m_parameters.bind();
    m_gl.BindBufferBase(GL_UNIFORM_BUFFER, kKernelBinding, m_kernel.get());
    m_gl.BindTextureUnit(0, get_depth(inputs).get());
    m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
    if (!is_packed() && m_params.use_history && m_effects.contains(Effect::object_motion)) {
        m_gl.BindTextureUnit(2, inputs.gbuffer.texture(Channel::motion).get());
    }
    m_gl.BindTextureUnit(3, old.history.get());
    const glm::vec2 tangents(compute_tangents(view.camera, view.size));
    const glm::mat3 view_from_world(glm::transpose(view.camera.world_from_view));
    const double near_m = view.previous_camera.near_m;
    const double far_m = view.previous_camera.far_m;
    m_gl.Uniform2f(program.location("tangents"), tangents.x, tangents.y);
    m_gl.UniformMatrix3fv(program.location("view_from_world"), 1, GL_FALSE,
                          glm::value_ptr(view_from_world));
    m_gl.Uniform1ui(program.location("noise_seed"), inputs.noise_seed);
    m_gl.Uniform1i(program.location("history_valid"), m_has_history && view.history_valid ? 1 : 0);
    m_gl.Uniform1f(program.location("post_projective_scale"),
                   static_cast<float>(far_m * near_m / (far_m - near_m)));
    set_reprojection_uniforms(m_gl, program.program(), make_reprojection(view));
    m_gl.Enable(GL_DEPTH_TEST);
    m_gl.DepthFunc(GL_ALWAYS);
    program.draw(inputs.wants_history_state ? fresh.state_framebuffer.get()
                                            : fresh.framebuffer.get(),
                 m_work_size);
    m_gl.Disable(GL_DEPTH_TEST);
    m_has_history = true;
}

void TssaoRenderer::filter(const MethodInputs& inputs, PassRecorder& passes) const {
    const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
    m_filter.use();
    m_parameters.bind();
    m_gl.BindTextureUnit(0, history().get());
    m_gl.Uniform2f(m_filter.location("tangents"), tangents.x, tangents.y);
    m_gl.Uniform2f(m_filter.location("image"), static_cast<float>(inputs.view.size.width),
                   static_cast<float>(inputs.view.size.height));
    m_gl.Enable(GL_DEPTH_TEST);
    m_gl.DepthFunc(GL_GREATER);
    m_gl.DepthMask(GL_FALSE);
    {
        const auto pass = passes.scope("tssao/filter_x");
        m_gl.Uniform2i(m_filter.location("direction"), 1, 0);
        m_gl.Uniform1i(m_filter.location("is_second"), 0);
        m_filter.draw(m_first_framebuffer.get(), m_work_size);
    }
    {
        const auto pass = passes.scope("tssao/filter_y");
        m_gl.BindTextureUnit(1, m_first.get());
        m_gl.Uniform2i(m_filter.location("direction"), 0, 1);
        m_gl.Uniform1i(m_filter.location("is_second"), 1);
        m_filter.draw(m_visibility_framebuffer.get(), m_work_size);
    }
    m_gl.DepthMask(GL_TRUE);
    m_gl.DepthFunc(GL_LESS);
    m_gl.Disable(GL_DEPTH_TEST);
}

void TssaoRenderer::resolve(const MethodInputs& inputs, PassRecorder& passes) const {
    const auto pass = passes.scope(m_params.resolution == TssaoResolution::half ? "tssao/upsample"
                                                                                : "tssao/crop");
    const Border border = make_border(m_size, get_requests().border);
    const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
    m_resolve.use();
    m_parameters.bind();
    m_gl.BindTextureUnit(0, m_visibility.get());
    m_gl.BindTextureUnit(1, get_depth(inputs).get());
    m_gl.BindTextureUnit(2, inputs.gbuffer.texture(Channel::normal).get());
    m_gl.BindTextureUnit(3, history().get());
    m_gl.Uniform2f(m_resolve.location("tangents"), tangents.x, tangents.y);
    m_gl.Uniform2i(m_resolve.location("border"), border.x, border.y);
    m_resolve.draw(m_resolved_framebuffer.get(), m_size);
}

MethodOutput TssaoRenderer::render(const MethodInputs& inputs, PassRecorder& passes) {
    accumulate(inputs, passes);
    if (m_params.filter_radius > 0) {
        filter(inputs, passes);
    }
    MethodOutput output;
    output.visibility = &m_visibility;
    if (m_resolved) {
        resolve(inputs, passes);
        output.visibility = &m_resolved;
    }
    output.history_state = inputs.wants_history_state && m_params.use_history ? &m_state : nullptr;
    return output;
}

} // namespace alcove
