#include "methods/hemisphere_ssao/hemisphere_ssao.hpp"

#include "core/frame/full_screen.hpp"
#include "methods/common/cross_bilateral_blur.hpp"
#include "methods/common/estimator_parameters.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/shaders.hpp"
#include "methods/common/unit_parts.hpp"

namespace alcove {
namespace {

constexpr GLuint kKernelBinding = 1;

ParameterTable make_table() {
    using P = HemisphereSsaoParams;
    return describe_parameters(
        "hemisphere_ssao",
        {
            describe_radius(&P::radius),
            integer(&P::samples, "samples")
                .range(1, 512)
                .log_scale()
                .rebuild()
                .unit("samples")
                .symbol("n")
                .meaning("Samples a pixel.")
                .source(kMattausch2010),
            describe_directions(&P::directions),
            boolean(&P::rotation, "rotation")
                .rebuild()
                .meaning("Turns the kernel by a random angle about the normal, a pixel.")
                .source(kMattausch2010),
            describe_cut(&P::cut),
            describe_bias(&P::bias),
            describe_border(&P::border),
            describe_strength(&P::strength),
            integer(&P::blur_radius, "blur_radius")
                .range(0, 8)
                .unit("px")
                .meaning("Taps on each side of the cross-bilateral blur; 0 is off.")
                .source(kMattausch2010),
            real(&P::blur_edge, "blur_edge")
                .range(0.001, 10.0)
                .log_scale()
                .unit("r")
                .meaning("Distance off the receiver's tangent plane at which a tap's weight is "
                         "1/e: small keeps edges "
                         "(weak blur), large blurs over them (strong blur).")
                .source("ours"),
        });
}

class HemisphereSsao final : public Method {
  public:
    HemisphereSsao(const gl::Functions& gl, const ResolvedParameters& resolved)
        : m_gl(gl), m_params(make_table().bind<HemisphereSsaoParams>(resolved)),
          m_parameters(gl, make_table(), resolved),
          m_occlusion(gl, make_method_shader_library(),
                      "methods/hemisphere_ssao/hemisphere_ssao_occlusion.frag.glsl",
                      m_parameters.generated_files()) {
        m_parameters.connect(m_occlusion.program());
        m_occlusion.program().bind_block("KernelBlock", kKernelBinding);
        const std::vector<glm::vec4> kernel =
            make_hemisphere_kernel(m_params.samples, m_params.directions);
        m_kernel = gl::create_buffer(gl, std::as_bytes(std::span(kernel)));
        if (m_params.blur_radius > 0) {
            m_blur.emplace(gl);
        }
    }

    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        m_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility});
        if (m_blur) {
            m_blur->resize(size);
        }
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        render_occlusion(inputs, passes);
        if (m_blur) {
            const CrossBilateralBlurSettings settings{m_params.blur_radius,
                                                      m_params.blur_edge * m_params.radius};
            m_blur->render(inputs, settings, m_visibility, m_framebuffer.get(), "hemisphere_ssao",
                           passes);
        }
        return {&m_visibility, nullptr};
    }

  private:
    void render_occlusion(const MethodInputs& inputs, PassRecorder& passes) {
        const auto pass = passes.scope("hemisphere_ssao/occlusion");
        const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
        m_occlusion.use();
        m_parameters.bind();
        m_gl.BindBufferBase(GL_UNIFORM_BUFFER, kKernelBinding, m_kernel.get());
        m_gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
        m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
        m_gl.Uniform2f(m_occlusion.location("tangents"), tangents.x, tangents.y);
        m_gl.Uniform1ui(m_occlusion.location("noise_seed"), inputs.noise_seed);
        m_occlusion.draw(m_framebuffer.get(), inputs.view.size);
    }

    const gl::Functions& m_gl;
    HemisphereSsaoParams m_params;
    ParameterBlock m_parameters;
    FullScreenProgram m_occlusion;
    std::optional<CrossBilateralBlur> m_blur;
    gl::BufferHandle m_kernel;
    gl::Texture m_visibility;
    gl::FramebufferHandle m_framebuffer;
};

/// Without bias a plane darkens where its depth changes within a pixel: that is what the paper's
/// form does.
std::vector<Preset> make_presets() {
    const char* const kNoBias = "no depth bias, as published: a tilted plane blocks itself "
                                "(3.5/255 at 60 degrees, 6.2/255 at 75)";
    return {
        {"default",
         "16 cosine samples, weak blur, bias of half a pixel footprint",
         {},
         1.0,
         2.0,
         ""},
        {"strong_blur", "as default, blurred over edges with a wider kernel",
         make_overrides({{"blur_radius", "4"}, {"blur_edge", "1"}}), 1.0, 2.0, ""},
        {"paper_weak_blur",
         "SSAO without history as Mattausch et al. 2010 compare with: 32 samples, high weight on "
         "discontinuities "
         "(kernel size not published, ours 5x5)",
         make_overrides({{"samples", "32"},
                         {"directions", "uniform"},
                         {"bias", "0"},
                         {"border", "clamp"},
                         {"blur_radius", "2"},
                         {"blur_edge", "0.05"}}),
         4.0, 7.0, kNoBias},
        {"paper_strong_blur",
         "the same with low weight on discontinuities (kernel size not published, ours 9x9)",
         make_overrides({{"samples", "32"},
                         {"directions", "uniform"},
                         {"bias", "0"},
                         {"border", "clamp"},
                         {"blur_radius", "4"},
                         {"blur_edge", "1"}}),
         4.0, 7.0, kNoBias},
        {"converged", "the estimator's own limit: 512 samples, no blur",
         make_overrides({{"samples", "512"}, {"blur_radius", "0"}}), 1.0, 2.0, ""},
    };
}

} // namespace

MethodUnit hemisphere_ssao_unit() {
    MethodUnit unit;
    unit.name = "hemisphere_ssao";
    unit.title = "Hemisphere SSAO";
    unit.citation =
        "Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion using temporal "
        "coherence. 2010 (its estimator, without history)";
    unit.parameters = make_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = map_linear_cosine_target;
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<HemisphereSsao>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
