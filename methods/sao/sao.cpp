#include "methods/sao/sao.hpp"

#include "core/frame/full_screen.hpp"
#include "methods/common/estimator_parameters.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/shaders.hpp"
#include "methods/common/unit_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alcove {
namespace {

constexpr const char* kMcGuire2012 = "McGuire et al. 2012";

ParameterTable make_table() {
    using P = SaoParams;
    return describe_parameters(
        "sao",
        {
            describe_radius(&P::radius).alive_with("border=clamp,bias=0"),
            describe_samples(&P::samples).source(kMcGuire2012),
            integer(&P::turns, "turns")
                .range(1, 64)
                .rebuild()
                .unit("turns")
                .symbol("tau")
                .meaning("Turns of the spiral.")
                .source(kMcGuire2012),
            describe_rotation(&P::rotation),
            real(&P::bias, "bias")
                .range(0.0, 0.5)
                .unit("r")
                .symbol("beta")
                .meaning("Height above the tangent plane below which a tap does not count.")
                .source(std::string(kMcGuire2012) + "; there in metres"),
            real(&P::epsilon, "epsilon")
                .range(1e-6, 1.0)
                .log_scale()
                .unit("r^2")
                .symbol("epsilon")
                .meaning("Keeps the nearest taps finite.")
                .source(std::string(kMcGuire2012) + "; there in square metres"),
            real(&P::intensity, "intensity")
                .range(0.05, 10.0)
                .log_scale()
                .unit("r")
                .symbol("sigma")
                .meaning("Factor on obscurance.")
                .source(std::string(kMcGuire2012) + "; there in metres"),
            integer(&P::first_level_log, "first_level_log")
                .range(0, 8)
                .rebuild()
                .unit("log2(px)")
                .symbol("q'")
                .meaning("Offsets up to 2^(q'+1) pixels read the depth buffer, each doubling from "
                         "there the next level.")
                .source(kMcGuire2012),
            integer(&P::levels, "levels")
                .range(1, 8)
                .rebuild()
                .unit("levels")
                .meaning("Levels of the depth pyramid beside the depth buffer.")
                .alive_with("first_level_log=0")
                .source(kMcGuire2012),
            describe_border(&P::border),
            describe_resolution(&P::resolution),
            describe_blur_radius(&P::blur_radius),
            describe_upsample_width(&P::upsample_width),
            describe_blur_edge(&P::blur_edge),
        });
}

/// Tap i: its direction (cos, sin) and its share (i + 0.5) / s of the radius.
std::vector<glm::vec4> make_spiral(int samples, int turns) {
    std::vector<glm::vec4> spiral;
    for (int i = 0; i < samples; ++i) {
        const double share = (i + 0.5) / samples;
        const double angle = share * turns * 2.0 * std::numbers::pi;
        spiral.emplace_back(std::cos(angle), std::sin(angle), share, 0.0);
    }
    return spiral;
}

/// Pass `sao/pyramid`: see sao_levels.glsl for its layout.
class Pyramid final : public EstimatorPreparation {
  public:
    Pyramid(const gl::Functions& gl, const ResolvedParameters& resolved)
        : m_gl(gl), m_parameters(gl, make_table(), resolved),
          m_levels(make_table().bind<SaoParams>(resolved).levels),
          m_program(gl, make_method_shader_library(), "methods/sao/sao_pyramid.frag.glsl",
                    m_parameters.generated_files()) {
        m_parameters.connect(m_program.program());
    }

    void resize(ImageSize size) override {
        int columns = 0;
        for (int level = 1; level <= m_levels; ++level) {
            columns += std::max(size.width >> level, 1);
        }
        m_pyramid = gl::Texture(m_gl, GL_R32F, {columns, std::max(size.height / 2, 1)});
        m_framebuffer = gl::create_framebuffer(m_gl, {&m_pyramid});
    }

    const gl::Texture& prepare(const MethodInputs& inputs, PassRecorder& passes) override {
        const auto pass = passes.scope("sao/pyramid");
        m_program.use();
        m_parameters.bind();
        m_gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
        m_program.draw(m_framebuffer.get(), m_pyramid.size());
        return m_pyramid;
    }

  private:
    const gl::Functions& m_gl;
    ParameterBlock m_parameters;
    int m_levels;
    FullScreenProgram m_program;
    gl::Texture m_pyramid;
    gl::FramebufferHandle m_framebuffer;
};

std::vector<Preset> make_presets() {
    return {
        {"default", "11 taps on a spiral of 7 turns, five levels, 9x9 blur", {}, 1.0, 2.0, ""},
        {"unfiltered", "as default, without the blur: a control",
         make_overrides({{"blur_radius", "0"}}), 1.0, 2.0, ""},
        {"no_pyramid", "as default, every tap from the depth buffer itself",
         make_overrides({{"first_level_log", "8"}}), 1.0, 2.0, ""},
        {"converged", "the estimator's own limit: 512 taps of the depth buffer, no blur",
         make_overrides(
             {{"samples", "512"}, {"turns", "31"}, {"first_level_log", "8"}, {"blur_radius", "0"}}),
         1.0, 2.0, ""},
    };
}

} // namespace

MethodUnit sao_unit() {
    MethodUnit unit;
    unit.name = "sao";
    unit.title = "Scalable ambient obscurance";
    unit.citation = "McGuire, Mara, Luebke. Scalable ambient obscurance. 2012";
    unit.parameters = make_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = [](const Target& target) {
        return map_radius(target, {.falloff = "(1 - (d/r)^2)^3 of a height over a squared distance",
                                   .weighting = "uniform over the disc on the screen"});
    };
    unit.count_samples = [](const ResolvedParameters& resolved) {
        const auto params = make_table().bind<SaoParams>(resolved);
        return count_estimator_samples("sao", params.samples,
                                       params.resolution == EstimatorResolution::half);
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        const auto params = make_table().bind<SaoParams>(resolved);
        const EstimatorRecipe recipe =
            make_estimator_recipe("sao", params, make_spiral(params.samples, params.turns));
        return make_estimator_method(context.functions(), make_table(), resolved, recipe,
                                     std::make_unique<Pyramid>(context.functions(), resolved));
    };
    return unit;
}

} // namespace alcove
