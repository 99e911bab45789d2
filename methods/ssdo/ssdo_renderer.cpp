#include "methods/ssdo/ssdo_renderer.hpp"

#include "core/frame/full_screen.hpp"
#include "methods/common/layered_surfaces.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/sample_sets.hpp"
#include "methods/common/shaders.hpp"
#include "methods/common/tile_blur.hpp"

#include <array>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace alcove {
namespace {

constexpr GLuint kKernelBinding = 1;
constexpr GLuint kLayerNormalUnit = 12;
constexpr GLuint kLayerSentUnit = 15;
constexpr GLuint kViewNormalUnit = 18;
constexpr GLuint kViewSentUnit = 22;

/// Right, up and backward of the viewer: cameras at its sides, above it, and beyond what it looks
/// at, aside so that none stands upright above the middle.
const std::array<glm::dvec3, kMostViews> kDisplacements{
    glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(-1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0),
    glm::dvec3(0.48, 0.36, -0.8)};

class Ssdo final : public Method {
  public:
    Ssdo(const gl::Functions& gl, const SsdoParams& params, const ParameterTable& table,
         const ResolvedParameters& resolved)
        : m_gl(gl), m_params(params), m_parameters(gl, table, resolved),
          m_direct(build("ssdo_direct", false, params.bounce)), m_blur(gl) {
        if (params.bounce) {
            m_bounce = build("ssdo_bounce", false, false);
            m_send = FullScreenProgram(gl, make_method_shader_library(),
                                       "methods/ssdo/ssdo_send.frag.glsl");
        }
        const auto kernel = make_sample_sets(params.tile, params.samples);
        m_kernel = gl::create_buffer(gl, std::as_bytes(std::span(kernel)));
    }

    MethodRequests get_requests() const override {
        MethodRequests requests;
        requests.channels = {Channel::eye_depth, Channel::normal, Channel::albedo,
                             Channel::direct_light};
        requests.layers = m_params.layers;
        for (int i = 0; i < m_params.views; ++i) {
            requests.views.push_back(
                {m_params.view_spread * kDisplacements.at(static_cast<std::size_t>(i)),
                 m_params.view_resolution});
        }
        requests.part_channels = ChannelSet{Channel::eye_depth};
        if (m_params.bounce) {
            requests.part_channels = requests.channels;
        }
        return requests;
    }

    void resize(ImageSize size) override {
        m_incoming = gl::Texture(m_gl, GL_RGBA32F, size);
        m_incoming_framebuffer = gl::create_framebuffer(m_gl, {&m_incoming});
        m_radiance = gl::Texture(m_gl, GL_RGBA16F, size);
        m_radiance_framebuffer = gl::create_framebuffer(m_gl, {&m_radiance});
        m_blur.resize(size);
        m_visibility = {};
        if (m_params.bounce) {
            m_direct_incoming = gl::Texture(m_gl, GL_RGBA32F, size);
            m_sent = gl::Texture(m_gl, GL_RGBA16F, size);
            m_direct_framebuffer = gl::create_framebuffer(m_gl, {&m_direct_incoming, &m_sent});
        }
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        ALCOVE_ASSERT(inputs.surroundings.radiance != nullptr, "light from all around");
        MethodOutput output;
        if (inputs.wants_visibility) {
            output.visibility = &render_visibility(inputs, passes);
        }
        if (m_params.bounce) {
            send_from_parts(inputs, passes);
        }
        {
            const auto pass = passes.scope("ssdo/direct");
            draw_direct(inputs, m_direct,
                        m_params.bounce ? m_direct_framebuffer.get()
                                        : m_incoming_framebuffer.get());
        }
        if (m_params.bounce) {
            const auto pass = passes.scope("ssdo/bounce");
            draw_bounce(inputs);
        }
        m_blur.render(inputs, get_blur(), m_incoming, m_radiance_framebuffer.get(), true, "ssdo",
                      passes);
        output.radiance = &m_radiance;
        return output;
    }

  private:
    FullScreenProgram build(const std::string& pass, bool gives_visibility, bool sends) {
        gl::GeneratedFiles files = m_parameters.generated_files();
        files["sample_set_counts.glsl"] = make_sample_set_counts(m_params.tile, m_params.samples);
        files["layer_counts.glsl"] = make_layer_counts(m_params.layers, m_params.views,
                                                       m_params.border == KernelBorder::clamp);
        files["direct_outputs.glsl"] = std::string("const bool kGivesVisibility = ") +
                                       (gives_visibility ? "true" : "false") + ";\n" +
                                       (sends ? "#define SENDS\n" : "");
        FullScreenProgram program(m_gl, make_method_shader_library(),
                                  "methods/ssdo/" + pass + ".frag.glsl", files);
        m_parameters.connect(program.program());
        program.program().bind_block("KernelBlock", kKernelBinding);
        return program;
    }

    TileBlurSettings get_blur() const {
        return {m_params.blur ? m_params.tile : 1, m_params.blur_edge * m_params.radius};
    }

    /// What both passes over samples read.
    void prepare(const MethodInputs& inputs, const FullScreenProgram& program) {
        program.use();
        m_parameters.bind();
        m_gl.BindBufferBase(GL_UNIFORM_BUFFER, kKernelBinding, m_kernel.get());
        bind_layered_surfaces(m_gl, program, inputs);
        m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
        m_gl.Uniform1ui(program.location("noise_seed"), inputs.noise_seed);
    }

    void draw_direct(const MethodInputs& inputs, const FullScreenProgram& program,
                     GLuint framebuffer) {
        prepare(inputs, program);
        m_gl.BindTextureUnit(2, inputs.gbuffer.texture(Channel::albedo).get());
        m_gl.BindTextureUnit(3, inputs.gbuffer.texture(Channel::direct_light).get());
        m_gl.BindTextureUnit(4, inputs.surroundings.radiance->get());
        m_gl.UniformMatrix3fv(program.location("map_from_view"), 1, GL_FALSE,
                              glm::value_ptr(inputs.surroundings.map_from_view));
        program.draw(framebuffer, inputs.view.size);
    }

    void draw_bounce(const MethodInputs& inputs) {
        prepare(inputs, m_bounce);
        m_gl.BindTextureUnit(2, m_sent.get());
        m_gl.BindTextureUnit(3, m_direct_incoming.get());
        for (std::size_t i = 0; i < inputs.layers.size(); ++i) {
            const auto unit = static_cast<GLuint>(i);
            m_gl.BindTextureUnit(kLayerNormalUnit + unit,
                                 inputs.layers[i]->texture(Channel::normal).get());
            m_gl.BindTextureUnit(kLayerSentUnit + unit, m_layers_sent[i].texture.get());
        }
        for (std::size_t i = 0; i < inputs.views.size(); ++i) {
            const auto unit = static_cast<GLuint>(i);
            m_gl.BindTextureUnit(kViewNormalUnit + unit,
                                 inputs.views[i].gbuffer->texture(Channel::normal).get());
            m_gl.BindTextureUnit(kViewSentUnit + unit, m_views_sent[i].texture.get());
        }
        m_bounce.draw(m_incoming_framebuffer.get(), inputs.view.size);
    }

    /// Radiance that the surfaces of a part send.
    struct Sent {
        gl::Texture texture;
        gl::FramebufferHandle framebuffer;
    };

    void send_from_parts(const MethodInputs& inputs, PassRecorder& passes) {
        m_layers_sent.resize(inputs.layers.size());
        m_views_sent.resize(inputs.views.size());
        const glm::mat3 map_from_world =
            inputs.surroundings.map_from_view *
            glm::mat3(glm::transpose(inputs.view.camera.world_from_view));
        for (std::size_t i = 0; i < inputs.layers.size(); ++i) {
            send(inputs, *inputs.layers[i], inputs.surroundings.map_from_view, true,
                 m_layers_sent[i], passes);
        }
        for (std::size_t i = 0; i < inputs.views.size(); ++i) {
            const MethodInputs::View& view = inputs.views[i];
            send(inputs, *view.gbuffer,
                 map_from_world * glm::mat3(view.view.camera.world_from_view), false,
                 m_views_sent[i], passes);
        }
    }

    void send(const MethodInputs& inputs, const GBuffer& gbuffer, const glm::mat3& map_from_view,
              bool is_layer, Sent& sent, PassRecorder& passes) {
        if (!sent.texture || !(sent.texture.size() == gbuffer.size())) {
            sent.texture = gl::Texture(m_gl, GL_RGBA16F, gbuffer.size());
            sent.framebuffer = gl::create_framebuffer(m_gl, {&sent.texture});
        }
        const auto pass = passes.scope("ssdo/send");
        m_send.use();
        m_gl.BindTextureUnit(0, gbuffer.texture(Channel::normal).get());
        m_gl.BindTextureUnit(1, gbuffer.texture(Channel::albedo).get());
        m_gl.BindTextureUnit(2, gbuffer.texture(Channel::direct_light).get());
        m_gl.BindTextureUnit(3, inputs.surroundings.prefiltered->get());
        m_gl.UniformMatrix3fv(m_send.location("map_from_view"), 1, GL_FALSE,
                              glm::value_ptr(map_from_view));
        m_gl.Uniform1i(m_send.location("sends_outward"), is_layer ? 1 : 0);
        m_send.draw(sent.framebuffer.get(), gbuffer.size());
    }

    /// The cosine-weighted share of free samples.
    const gl::Texture& render_visibility(const MethodInputs& inputs, PassRecorder& passes) {
        if (!m_shows_visibility) {
            m_shows_visibility = build("ssdo_direct", true, false);
        }
        if (!m_visibility) {
            m_visibility = gl::Texture(m_gl, GL_R32F, inputs.view.size);
            m_visibility_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility});
        }
        {
            const auto pass = passes.scope("ssdo/visibility");
            draw_direct(inputs, *m_shows_visibility, m_incoming_framebuffer.get());
        }
        m_blur.render(inputs, get_blur(), m_incoming, m_visibility_framebuffer.get(), false, "ssdo",
                      passes);
        return m_visibility;
    }

    const gl::Functions& m_gl;
    SsdoParams m_params;
    ParameterBlock m_parameters;
    FullScreenProgram m_direct;
    FullScreenProgram m_bounce;
    FullScreenProgram m_send;
    std::optional<FullScreenProgram> m_shows_visibility; ///< compiled when it is first asked for
    TileBlur m_blur;
    gl::BufferHandle m_kernel;
    gl::Texture m_incoming; ///< what is blurred: mean incoming radiance, and eye depth
    gl::FramebufferHandle m_incoming_framebuffer;
    gl::Texture m_direct_incoming; ///< with bounce: of the direct pass
    gl::Texture m_sent;
    gl::FramebufferHandle m_direct_framebuffer;
    std::vector<Sent> m_layers_sent;
    std::vector<Sent> m_views_sent;
    gl::Texture m_radiance;
    gl::FramebufferHandle m_radiance_framebuffer;
    gl::Texture m_visibility;
    gl::FramebufferHandle m_visibility_framebuffer;
};

} // namespace

std::unique_ptr<Method> make_ssdo(const gl::Functions& gl, const SsdoParams& params,
                                  const ParameterTable& table, const ResolvedParameters& resolved) {
    return std::make_unique<Ssdo>(gl, params, table, resolved);
}

} // namespace alcove
