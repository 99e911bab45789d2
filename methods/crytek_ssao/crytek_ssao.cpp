#include "methods/crytek_ssao/crytek_ssao.hpp"

#include "core/frame/full_screen.hpp"
#include "methods/common/bilateral_upsample.hpp"
#include "methods/common/cross_bilateral_blur.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/shaders.hpp"
#include "methods/common/unit_parts.hpp"
#include "methods/crytek_ssao/crytek_ssao_description.hpp"

namespace alcove {
namespace {

constexpr GLuint kKernelBinding = 1;
constexpr const char* kName = "crytek_ssao";

class CrytekSsao final : public Method {
  public:
    CrytekSsao(const gl::Functions& gl, const ResolvedParameters& resolved)
        : m_gl(gl), m_params(make_crytek_table().bind<CrytekSsaoParams>(resolved)),
          m_parameters(gl, make_crytek_table(), resolved),
          m_occlusion(gl, make_method_shader_library(),
                      "methods/crytek_ssao/crytek_ssao_occlusion.frag.glsl",
                      m_parameters.generated_files()) {
        m_parameters.connect(m_occlusion.program());
        m_occlusion.program().bind_block("KernelBlock", kKernelBinding);
        const std::vector<glm::vec4> kernel = make_crytek_kernel(m_params);
        m_kernel = gl::create_buffer(gl, std::as_bytes(std::span(kernel)));
        if (m_params.resolution == CrytekResolution::half) {
            m_upsample.emplace(gl);
        }
        if (m_params.blur_radius > 0) {
            m_blur.emplace(gl);
        }
    }

    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        m_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility});
        if (m_upsample) {
            m_upsample->resize(size);
            m_half = gl::Texture(m_gl, GL_R32F, m_upsample->half_size());
            m_half_framebuffer = gl::create_framebuffer(m_gl, {&m_half});
        }
        if (m_blur) {
            m_blur->resize(size);
        }
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        const double edge_m = m_params.blur_edge * m_params.radius;
        if (m_upsample) {
            m_upsample->select(inputs, kName, passes);
            render_occlusion(inputs, m_half_framebuffer.get(), m_half.size(), passes);
            m_upsample->render(inputs, {m_params.upsample_width, edge_m}, m_half,
                               m_framebuffer.get(), kName, passes);
        } else {
            render_occlusion(inputs, m_framebuffer.get(), inputs.view.size, passes);
        }
        if (m_blur) {
            m_blur->render(inputs, {m_params.blur_radius, edge_m}, m_visibility,
                           m_framebuffer.get(), kName, passes);
        }
        return {&m_visibility, nullptr};
    }

  private:
    void render_occlusion(const MethodInputs& inputs, GLuint framebuffer, ImageSize size,
                          PassRecorder& passes) {
        const auto pass = passes.scope("crytek_ssao/occlusion");
        const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
        m_occlusion.use();
        m_parameters.bind();
        m_gl.BindBufferBase(GL_UNIFORM_BUFFER, kKernelBinding, m_kernel.get());
        m_gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
        m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
        if (m_upsample) {
            m_gl.BindTextureUnit(2, m_upsample->selection().get());
        }
        m_gl.Uniform2f(m_occlusion.location("tangents"), tangents.x, tangents.y);
        m_gl.Uniform1ui(m_occlusion.location("noise_seed"), inputs.noise_seed);
        m_occlusion.draw(framebuffer, size);
    }

    const gl::Functions& m_gl;
    CrytekSsaoParams m_params;
    ParameterBlock m_parameters;
    FullScreenProgram m_occlusion;
    std::optional<BilateralUpsample> m_upsample;
    std::optional<CrossBilateralBlur> m_blur;
    gl::BufferHandle m_kernel;
    gl::Texture m_visibility;
    gl::FramebufferHandle m_framebuffer;
    gl::Texture m_half;
    gl::FramebufferHandle m_half_framebuffer;
};

/// Radius and weighting are parameters; the rest is as for all estimators with uniform steps.
TargetMapping map_target(const Target& target) {
    Target but_weighting = target;
    but_weighting.weighting = Weighting::cosine;
    TargetMapping mapping = map_linear_cosine_target(but_weighting);
    mapping.overrides.push_back(
        {"weighting", std::string(to_text(target.weighting)), Provenance::target});
    return mapping;
}

} // namespace

MethodUnit crytek_ssao_unit() {
    MethodUnit unit;
    unit.name = kName;
    unit.title = "Crytek SSAO";
    unit.citation = "Mittring. Finding next gen: CryEngine 2. 2007";
    unit.parameters = make_crytek_table();
    unit.presets = make_crytek_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = map_target;
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<CrytekSsao>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
