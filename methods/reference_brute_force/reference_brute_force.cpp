#include "methods/reference_brute_force/reference_brute_force.hpp"

#include "core/frame/full_screen.hpp"
#include "methods/common/estimator_parameters.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/shaders.hpp"
#include "methods/common/traced_target.hpp"

#include <algorithm>
#include <array>

namespace alcove {
namespace {

/// Rays of one draw: a GPU's watchdog ends draws of seconds.
constexpr int kRaysPerDraw = 32;

ParameterTable make_table() {
    using P = ReferenceBruteForceParams;
    const char* const kMcGuire2014 = "McGuire, Mara 2014";
    return describe_parameters(
        "reference_brute_force",
        {
            describe_target_radius(&P::radius),
            integer(&P::rays, "rays")
                .range(1, 4096)
                .log_scale()
                .unit("rays")
                .symbol("N")
                .meaning("Rays a pixel.")
                .source("ours"),
            real(&P::step, "step")
                .range(0.25, 16.0)
                .log_scale()
                .unit("px")
                .meaning("Length of a step along the screen's longer axis.")
                .source(kMcGuire2014),
            integer(&P::least_steps, "least_steps")
                .range(1, 256)
                .log_scale()
                .unit("steps")
                .meaning("Steps of a ray that is shorter on the screen.")
                .source("ours"),
            real(&P::thickness, "thickness")
                .range(1e-3, 100.0)
                .log_scale()
                .may_be_infinite()
                .unit("r")
                .meaning("How deep a surface is taken to be behind what the depth buffer shows.")
                .source(kMcGuire2014),
            describe_bias(&P::bias),
            describe_target_falloff(&P::falloff),
            describe_target_weighting(&P::weighting),
        });
}

class ReferenceBruteForce final : public Method {
  public:
    ReferenceBruteForce(const gl::Functions& gl, const ResolvedParameters& resolved)
        : m_gl(gl), m_params(make_table().bind<ReferenceBruteForceParams>(resolved)),
          m_parameters(gl, make_table(), resolved),
          m_march(gl, make_method_shader_library(),
                  "methods/reference_brute_force/reference_brute_force_march.frag.glsl",
                  m_parameters.generated_files()) {
        m_parameters.connect(m_march.program());
    }

    void resize(ImageSize size) override {
        for (Target& target : m_targets) {
            target.visibility = gl::Texture(m_gl, GL_R32F, size);
            target.framebuffer = gl::create_framebuffer(m_gl, {&target.visibility});
        }
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        const auto pass = passes.scope("reference_brute_force/march");
        const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
        m_march.use();
        m_parameters.bind();
        m_gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
        m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
        m_gl.Uniform2f(m_march.location("tangents"), tangents.x, tangents.y);
        m_gl.Uniform1ui(m_march.location("noise_seed"), inputs.noise_seed);
        std::size_t to = 0;
        for (int first = 0; first < m_params.rays; first += kRaysPerDraw) {
            const int end = std::min(first + kRaysPerDraw, m_params.rays);
            m_gl.BindTextureUnit(2, m_targets.at(1 - to).visibility.get());
            m_gl.Uniform1ui(m_march.location("first_ray"), static_cast<GLuint>(first));
            m_gl.Uniform1ui(m_march.location("end_ray"), static_cast<GLuint>(end));
            m_march.draw(m_targets.at(to).framebuffer.get(), inputs.view.size);
            to = 1 - to;
        }
        return {&m_targets.at(1 - to).visibility, nullptr};
    }

  private:
    /// Read and written in turn.
    struct Target {
        gl::Texture visibility;
        gl::FramebufferHandle framebuffer;
    };

    const gl::Functions& m_gl;
    ReferenceBruteForceParams m_params;
    ParameterBlock m_parameters;
    FullScreenProgram m_march;
    std::array<Target, 2> m_targets;
};

} // namespace

MethodUnit reference_brute_force_unit() {
    MethodUnit unit;
    unit.name = "reference_brute_force";
    unit.title = "Brute-force screen-space march";
    unit.citation = "McGuire, Mara. Efficient GPU screen-space ray tracing. 2014 (its march, one "
                    "pixel a step, as a reference)";
    unit.is_reference = true;
    unit.parameters = make_table();
    unit.presets = {{"default", "256 rays, a pixel a step, infinite thickness", {}, 1.0, 2.0, ""}};
    unit.plane_response = 1.0;
    unit.map_target = map_target_on_shading_normals;
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<ReferenceBruteForce>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
