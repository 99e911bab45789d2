#include "methods/shanmugam_arikan/shanmugam_arikan.hpp"

#include "core/frame/full_screen.hpp"
#include "methods/common/kernels.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/shaders.hpp"
#include "methods/common/unit_parts.hpp"
#include "methods/shanmugam_arikan/billboards.hpp"
#include "methods/shanmugam_arikan/shanmugam_arikan_description.hpp"

#include <optional>

namespace alcove {
namespace {

constexpr GLuint kKernelBinding = 1;
constexpr GLuint kFirstNormalUnit = 4;

gl::GeneratedFiles add_layers(gl::GeneratedFiles files, int layers) {
    files["parameters.glsl"] += "#define LAYERS " + std::to_string(layers) + "\n";
    return files;
}

class ShanmugamArikan final : public Method {
  public:
    ShanmugamArikan(const gl::Functions& gl, const ResolvedParameters& resolved)
        : m_gl(gl), m_params(make_shanmugam_arikan_table().bind<ShanmugamArikanParams>(resolved)),
          m_parameters(gl, make_shanmugam_arikan_table(), resolved),
          m_combine(gl, make_method_shader_library(),
                    "methods/shanmugam_arikan/shanmugam_arikan_combine.frag.glsl",
                    m_parameters.generated_files()) {
        m_parameters.connect(m_combine.program());
        if (m_params.part != OcclusionPart::far) {
            m_near = FullScreenProgram(gl, make_method_shader_library(),
                                       "methods/shanmugam_arikan/shanmugam_arikan_near.frag.glsl",
                                       add_layers(m_parameters.generated_files(), count_layers()));
            m_parameters.connect(m_near.program());
            m_near.program().bind_block("KernelBlock", kKernelBinding);
            const std::vector<glm::vec4> kernel = make_disc_kernel(m_params.samples);
            m_kernel = gl::create_buffer(gl, std::as_bytes(std::span(kernel)));
        }
        if (m_params.part != OcclusionPart::near) {
            m_billboards.emplace(gl, m_params, m_parameters);
        }
    }

    MethodRequests get_requests() const override {
        MethodRequests requests;
        requests.posed_geometry = m_billboards.has_value();
        if (m_params.part != OcclusionPart::far && count_layers() > 1) {
            if (m_params.second == SecondSurface::back_faces) {
                requests.back_faces = true;
            } else {
                requests.layers = m_params.layers;
            }
        }
        return requests;
    }

    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        m_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility});
        if (m_params.part != OcclusionPart::far) {
            m_near_occlusion = gl::Texture(m_gl, GL_R32F, size);
            m_near_framebuffer = gl::create_framebuffer(m_gl, {&m_near_occlusion});
        }
        if (m_billboards) {
            m_billboards->resize(size);
        }
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        if (m_params.part != OcclusionPart::far) {
            render_near(inputs, passes);
        }
        const gl::Texture* far = nullptr;
        if (m_billboards) {
            far = &m_billboards->render(inputs, passes);
        }
        combine(inputs, far, passes);
        return {&m_visibility, nullptr};
    }

  private:
    /// Back faces are one more layer whatever `layers` says beyond 1.
    [[nodiscard]] int count_layers() const {
        const bool has_back_faces = m_params.second == SecondSurface::back_faces;
        return has_back_faces ? std::min(m_params.layers, 2) : m_params.layers;
    }

    void bind_layer(GLuint layer, const GBuffer& gbuffer) const {
        m_gl.BindTextureUnit(layer, gbuffer.texture(Channel::eye_depth).get());
        m_gl.BindTextureUnit(kFirstNormalUnit + layer, gbuffer.texture(Channel::normal).get());
    }

    void render_near(const MethodInputs& inputs, PassRecorder& passes) const {
        const auto pass = passes.scope("shanmugam_arikan/near");
        const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
        m_near.use();
        m_parameters.bind();
        m_gl.BindBufferBase(GL_UNIFORM_BUFFER, kKernelBinding, m_kernel.get());
        bind_layer(0, inputs.gbuffer);
        if (inputs.back_faces != nullptr) {
            bind_layer(1, *inputs.back_faces);
        }
        for (std::size_t i = 0; i < inputs.layers.size(); ++i) {
            bind_layer(static_cast<GLuint>(i + 1), *inputs.layers[i]);
        }
        m_gl.Uniform2f(m_near.location("tangents"), tangents.x, tangents.y);
        m_gl.Uniform1ui(m_near.location("noise_seed"), inputs.noise_seed);
        m_near.draw(m_near_framebuffer.get(), inputs.view.size);
    }

    void combine(const MethodInputs& inputs, const gl::Texture* far, PassRecorder& passes) const {
        const auto pass = passes.scope("shanmugam_arikan/combine");
        m_combine.use();
        m_parameters.bind();
        m_gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
        m_gl.BindTextureUnit(1, m_near_occlusion.get());
        m_gl.BindTextureUnit(2, far != nullptr ? far->get() : 0);
        m_combine.draw(m_framebuffer.get(), inputs.view.size);
    }

    const gl::Functions& m_gl;
    ShanmugamArikanParams m_params;
    ParameterBlock m_parameters;
    FullScreenProgram m_near;
    FullScreenProgram m_combine;
    std::optional<Billboards> m_billboards;
    gl::BufferHandle m_kernel;
    gl::Texture m_near_occlusion; ///< none without the near part
    gl::FramebufferHandle m_near_framebuffer;
    gl::Texture m_visibility;
    gl::FramebufferHandle m_framebuffer;
};

} // namespace

MethodUnit shanmugam_arikan_unit() {
    MethodUnit unit;
    unit.name = "shanmugam_arikan";
    unit.title = "Near and far spheres";
    unit.citation =
        "Shanmugam, Arikan. Hardware accelerated ambient occlusion techniques on GPUs. 2007";
    unit.parameters = make_shanmugam_arikan_table();
    unit.presets = make_shanmugam_arikan_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = [](const Target& target) {
        TargetMapping mapping = map_radius(
            target, {.falloff = "that of a solid angle, none up to half the radius and none of the "
                                "near part beyond it",
                     .weighting = "cosine"});
        // The near part reaches half of the radius, spheres all of it.
        mapping.overrides = {
            {"r_far", to_text(ParameterValue{0.5 * target.radius_m}), Provenance::target},
            {"reach", to_text(ParameterValue{target.radius_m}), Provenance::target}};
        return mapping;
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<ShanmugamArikan>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
