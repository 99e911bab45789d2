#include "methods/common/estimator_method.hpp"

#include "core/frame/full_screen.hpp"
#include "methods/common/bilateral_upsample.hpp"
#include "methods/common/cross_bilateral_blur.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/shaders.hpp"

#include <optional>
#include <utility>

namespace alcove {
namespace {

constexpr GLuint kKernelBinding = 1;

gl::GeneratedFiles add_resolution(gl::GeneratedFiles files, EstimatorResolution resolution) {
    const bool is_half = resolution == EstimatorResolution::half;
    files["estimator_resolution.glsl"] =
        std::string("const bool kIsHalfResolution = ") + (is_half ? "true" : "false") + ";\n";
    return files;
}

class EstimatorMethod final : public Method {
  public:
    EstimatorMethod(const gl::Functions& gl, const ParameterTable& table,
                    const ResolvedParameters& resolved, const EstimatorRecipe& recipe,
                    std::unique_ptr<EstimatorPreparation> preparation)
        : m_gl(gl), m_recipe(recipe), m_preparation(std::move(preparation)),
          m_parameters(gl, table, resolved),
          m_occlusion(gl, make_method_shader_library(),
                      "methods/" + recipe.name + "/" + recipe.name + "_occlusion.frag.glsl",
                      add_resolution(m_parameters.generated_files(), recipe.resolution)) {
        m_parameters.connect(m_occlusion.program());
        if (!recipe.kernel.empty()) {
            m_occlusion.program().bind_block("KernelBlock", kKernelBinding);
            m_kernel = gl::create_buffer(gl, std::as_bytes(std::span(recipe.kernel)));
        }
        if (recipe.resolution == EstimatorResolution::half) {
            m_upsample.emplace(gl);
        } else if (recipe.blur_radius > 0) {
            m_blur.emplace(gl);
        }
    }

    [[nodiscard]] MethodRequests get_requests() const override { return m_recipe.requests; }

    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        m_framebuffer = gl::create_framebuffer(m_gl, {&m_visibility});
        if (m_preparation) {
            m_preparation->resize(size);
        }
        if (m_blur) {
            m_blur->resize(size);
        }
        if (m_upsample) {
            m_upsample->resize(size);
            m_half_visibility = gl::Texture(m_gl, GL_R32F, m_upsample->half_size());
            m_half_framebuffer = gl::create_framebuffer(m_gl, {&m_half_visibility});
        }
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        const gl::Texture* prepared =
            m_preparation ? &m_preparation->prepare(inputs, passes) : nullptr;
        if (m_upsample) {
            m_upsample->select(inputs, m_recipe.name, passes);
            estimate(inputs, prepared, m_half_framebuffer.get(), m_upsample->half_size(), passes);
            m_upsample->render(inputs, {m_recipe.upsample_width, m_recipe.edge_distance_m},
                               m_half_visibility, m_framebuffer.get(), m_recipe.name, passes);
        } else {
            estimate(inputs, prepared, m_framebuffer.get(), inputs.view.size, passes);
            if (m_blur) {
                m_blur->render(inputs, {m_recipe.blur_radius, m_recipe.edge_distance_m},
                               m_visibility, m_framebuffer.get(), m_recipe.name, passes);
            }
        }
        return {&m_visibility, nullptr};
    }

  private:
    void estimate(const MethodInputs& inputs, const gl::Texture* prepared, GLuint framebuffer,
                  ImageSize size, PassRecorder& passes) {
        const auto pass = passes.scope(m_recipe.name + "/occlusion");
        const glm::vec2 tangents(compute_tangents(inputs.view.camera, inputs.view.size));
        m_occlusion.use();
        m_parameters.bind();
        if (m_kernel) {
            m_gl.BindBufferBase(GL_UNIFORM_BUFFER, kKernelBinding, m_kernel.get());
        }
        m_gl.BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
        m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
        if (m_upsample) {
            m_gl.BindTextureUnit(2, m_upsample->selection().get());
        }
        if (prepared != nullptr) {
            m_gl.BindTextureUnit(3, prepared->get());
        }
        m_gl.Uniform2f(m_occlusion.location("tangents"), tangents.x, tangents.y);
        m_gl.Uniform1ui(m_occlusion.location("noise_seed"), inputs.noise_seed);
        m_occlusion.draw(framebuffer, size);
    }

    const gl::Functions& m_gl;
    EstimatorRecipe m_recipe;
    std::unique_ptr<EstimatorPreparation> m_preparation;
    ParameterBlock m_parameters;
    FullScreenProgram m_occlusion;
    std::optional<CrossBilateralBlur> m_blur;
    std::optional<BilateralUpsample> m_upsample;
    gl::BufferHandle m_kernel;
    gl::Texture m_visibility;
    gl::FramebufferHandle m_framebuffer;
    gl::Texture m_half_visibility;
    gl::FramebufferHandle m_half_framebuffer;
};

} // namespace

std::unique_ptr<Method> make_estimator_method(const gl::Functions& gl, const ParameterTable& table,
                                              const ResolvedParameters& resolved,
                                              const EstimatorRecipe& recipe,
                                              std::unique_ptr<EstimatorPreparation> preparation) {
    return std::make_unique<EstimatorMethod>(gl, table, resolved, recipe, std::move(preparation));
}

} // namespace alcove
