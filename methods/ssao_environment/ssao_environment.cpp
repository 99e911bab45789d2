#include "methods/ssao_environment/ssao_environment.hpp"

#include "core/frame/full_screen.hpp"
#include "methods/common/estimator_parameters.hpp"
#include "methods/common/layered_surfaces.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/sample_sets.hpp"
#include "methods/common/shaders.hpp"
#include "methods/common/tile_blur.hpp"
#include "methods/common/unit_parts.hpp"

#include <optional>

#include <glm/gtc/type_ptr.hpp>

namespace alcove {
namespace {

constexpr GLuint kKernelBinding = 1;

ParameterTable make_table() {
    using P = SsaoEnvironmentParams;
    return describe_parameters(
        "ssao_environment",
        {
            describe_radius(&P::radius),
            describe_set_samples(&P::samples).meaning("Samples a pixel."),
            describe_tile(&P::tile),
            choice(&P::weighting, "weighting", {"cosine", "uniform"})
                .rebuild()
                .meaning("What a free sample counts: the cosine to the normal, or all alike, as "
                         "classic ambient occlusion.")
                .source("uniform: Ritschel et al. 2009"),
            choice(&P::dimmed, "dimmed", {"surroundings", "all"})
                .rebuild()
                .meaning("What visibility is multiplied on: the light of the surroundings, or "
                         "direct light with its shadow maps as well.")
                .source("all: Ritschel et al. 2009, figure 10"),
            describe_fade(&P::fade),
            describe_border(&P::border),
            describe_bias(&P::bias),
            describe_tile_blur(&P::blur),
            describe_blur_edge(&P::blur_edge),
        });
}

class SsaoEnvironment final : public Method {
  public:
    SsaoEnvironment(const gl::Functions& gl, const ResolvedParameters& resolved)
        : m_gl(gl), m_params(make_table().bind<SsaoEnvironmentParams>(resolved)),
          m_parameters(gl, make_table(), resolved),
          m_occlusion(build(m_params.dimmed == DimmedLight::all)), m_blur(gl) {
        if (m_params.dimmed == DimmedLight::all) {
            m_shade =
                FullScreenProgram(gl, make_method_shader_library(),
                                  "methods/ssao_environment/ssao_environment_shade_all.frag.glsl");
        }
        const auto kernel = make_sample_sets(m_params.tile, m_params.samples);
        m_kernel = gl::create_buffer(gl, std::as_bytes(std::span(kernel)));
    }

    MethodRequests get_requests() const override {
        return {{Channel::eye_depth, Channel::normal, Channel::albedo, Channel::direct_light}};
    }

    void resize(ImageSize size) override {
        m_incoming = gl::Texture(m_gl, GL_RGBA32F, size);
        m_incoming_framebuffer = gl::create_framebuffer(m_gl, {&m_incoming});
        m_radiance = gl::Texture(m_gl, GL_RGBA16F, size);
        m_radiance_framebuffer = gl::create_framebuffer(m_gl, {&m_radiance});
        m_visibility = {};
        m_blur.resize(size);
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        ALCOVE_ASSERT(inputs.surroundings.prefiltered != nullptr, "light from all around");
        MethodOutput output;
        if (m_params.dimmed == DimmedLight::all) {
            output.visibility = &render_visibility(inputs, m_occlusion, "occlusion", passes);
            shade_all(inputs, passes);
            output.replaces_direct_light = true;
        } else {
            if (inputs.wants_visibility) {
                if (!m_shows_visibility) {
                    m_shows_visibility = build(true);
                }
                output.visibility =
                    &render_visibility(inputs, *m_shows_visibility, "visibility", passes);
            }
            {
                const auto pass = passes.scope("ssao_environment/occlusion");
                draw(inputs, m_occlusion);
            }
            finish(inputs, m_radiance_framebuffer.get(), true, passes);
        }
        output.radiance = &m_radiance;
        return output;
    }

  private:
    FullScreenProgram build(bool gives_visibility) {
        gl::GeneratedFiles files = m_parameters.generated_files();
        files["sample_set_counts.glsl"] = make_sample_set_counts(m_params.tile, m_params.samples);
        files["layer_counts.glsl"] =
            make_layer_counts(1, 0, m_params.border == KernelBorder::clamp);
        files["direct_outputs.glsl"] = std::string("const bool kGivesVisibility = ") +
                                       (gives_visibility ? "true" : "false") + ";\n";
        FullScreenProgram program(m_gl, make_method_shader_library(),
                                  "methods/ssao_environment/ssao_environment_occlusion.frag.glsl",
                                  files);
        m_parameters.connect(program.program());
        program.program().bind_block("KernelBlock", kKernelBinding);
        return program;
    }

    void draw(const MethodInputs& inputs, const FullScreenProgram& program) {
        program.use();
        m_parameters.bind();
        m_gl.BindBufferBase(GL_UNIFORM_BUFFER, kKernelBinding, m_kernel.get());
        bind_layered_surfaces(m_gl, program, inputs);
        m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
        m_gl.BindTextureUnit(4, inputs.surroundings.prefiltered->get());
        m_gl.UniformMatrix3fv(program.location("map_from_view"), 1, GL_FALSE,
                              glm::value_ptr(inputs.surroundings.map_from_view));
        m_gl.Uniform1ui(program.location("noise_seed"), inputs.noise_seed);
        program.draw(m_incoming_framebuffer.get(), inputs.view.size);
    }

    const gl::Texture& render_visibility(const MethodInputs& inputs,
                                         const FullScreenProgram& program, const std::string& pass,
                                         PassRecorder& passes) {
        if (!m_visibility) {
            m_visibility = gl::Texture(m_gl, GL_R32F, inputs.view.size);
            m_visibility_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility});
        }
        {
            const auto scope = passes.scope("ssao_environment/" + pass);
            draw(inputs, program);
        }
        finish(inputs, m_visibility_framebuffer.get(), false, passes);
        return m_visibility;
    }

    /// From the blurred visibility.
    void shade_all(const MethodInputs& inputs, PassRecorder& passes) {
        const auto pass = passes.scope("ssao_environment/shade_all");
        m_shade.use();
        m_gl.BindTextureUnit(0, m_visibility.get());
        m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
        m_gl.BindTextureUnit(2, inputs.gbuffer.texture(Channel::albedo).get());
        m_gl.BindTextureUnit(3, inputs.gbuffer.texture(Channel::direct_light).get());
        m_gl.BindTextureUnit(4, inputs.surroundings.prefiltered->get());
        m_gl.UniformMatrix3fv(m_shade.location("map_from_view"), 1, GL_FALSE,
                              glm::value_ptr(inputs.surroundings.map_from_view));
        m_shade.draw(m_radiance_framebuffer.get(), inputs.view.size);
    }

    void finish(const MethodInputs& inputs, GLuint target, bool is_shaded, PassRecorder& passes) {
        m_blur.render(inputs,
                      {m_params.blur ? m_params.tile : 1, m_params.blur_edge * m_params.radius},
                      m_incoming, target, is_shaded, "ssao_environment", passes);
    }

    const gl::Functions& m_gl;
    SsaoEnvironmentParams m_params;
    ParameterBlock m_parameters;
    FullScreenProgram m_occlusion;
    FullScreenProgram m_shade;                           ///< where all light is dimmed
    std::optional<FullScreenProgram> m_shows_visibility; ///< compiled when it is first asked for
    TileBlur m_blur;
    gl::BufferHandle m_kernel;
    gl::Texture m_incoming; ///< mean incoming radiance, and eye depth
    gl::FramebufferHandle m_incoming_framebuffer;
    gl::Texture m_radiance;
    gl::FramebufferHandle m_radiance_framebuffer;
    gl::Texture m_visibility;
    gl::FramebufferHandle m_visibility_framebuffer;
};

std::vector<Preset> make_presets() {
    return {
        {"default", "16 samples in 4x4 sets, free samples count alike", {}, 1.0, 2.0, ""},
        {"cosine", "free samples count by their cosine: what a constant environment makes of ssdo",
         make_overrides({{"weighting", "cosine"}}), 1.0, 2.0, ""},
        {"all_light", "multiplied on direct light with its shadow maps as well",
         make_overrides({{"dimmed", "all"}}), 1.0, 2.0, ""},
        {"paper_8", "as published: 8 samples, no bias",
         make_overrides({{"samples", "8"}, {"bias", "0"}}), 16.0, 16.0,
         "no depth bias, as published: a tilted plane blocks itself"},
        {"paper_16", "as published: 16 samples, no bias",
         make_overrides({{"samples", "16"}, {"bias", "0"}}), 16.0, 16.0,
         "no depth bias, as published: a tilted plane blocks itself"},
        {"converged", "the estimator's own limit: 256 samples, no blur",
         make_overrides({{"samples", "256"}, {"blur", "false"}}), 1.0, 2.0, ""},
    };
}

} // namespace

MethodUnit ssao_environment_unit() {
    MethodUnit unit;
    unit.name = "ssao_environment";
    unit.title = "Ambient occlusion times one environment lookup";
    unit.citation = "Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image "
                    "space. 2009 (the SSAO that they compare with)";
    unit.parameters = make_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = [](const Target& target) {
        TargetMapping mapping =
            map_radius(target, {"linear", std::string(to_text(target.weighting))});
        mapping.overrides.push_back(
            {"weighting", std::string(to_text(target.weighting)), Provenance::target});
        return mapping;
    };
    unit.count_samples = [](const ResolvedParameters& resolved) {
        const auto params = make_table().bind<SsaoEnvironmentParams>(resolved);
        return count_estimator_samples("ssao_environment", params.samples, false);
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<SsaoEnvironment>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
