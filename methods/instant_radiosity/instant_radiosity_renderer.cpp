#include "methods/instant_radiosity/instant_radiosity_renderer.hpp"

#include "methods/common/layered_surfaces.hpp"
#include "methods/common/light_sum.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/sample_sets.hpp"
#include "methods/common/shaders.hpp"
#include "methods/common/shadow_maps.hpp"
#include "methods/common/tile_blur.hpp"
#include "methods/instant_radiosity/virtual_lights.hpp"

#include <numbers>
#include <optional>

#include <glm/matrix.hpp>

namespace alcove {
namespace {

constexpr GLuint kKernelBinding = 1;

class InstantRadiosity final : public Method {
  public:
    InstantRadiosity(const gl::Functions& gl, const InstantRadiosityParams& params,
                     const ParameterTable& table, const ResolvedParameters& resolved)
        : m_gl(gl), m_params(params), m_parameters(gl, table, resolved), m_sum(gl),
          m_rsms(gl, params.rsm_size), m_maps(gl, params.map_size), m_light(build("light", "\n")),
          m_blur(gl) {
        if (has_near_bounce()) {
            m_near = build("near", "\n");
            const auto kernel = make_sample_sets(params.tile, params.near_samples);
            m_kernel = gl::create_buffer(gl, std::as_bytes(std::span(kernel)));
        }
    }

    MethodRequests get_requests() const override {
        MethodRequests requests;
        requests.channels = {Channel::eye_depth, Channel::normal, Channel::albedo,
                             Channel::direct_light};
        requests.layers = m_params.layers;
        requests.part_channels = ChannelSet{Channel::eye_depth};
        return requests;
    }

    void resize(ImageSize size) override {
        m_sum.resize(size);
        if (has_near_bounce()) {
            m_incoming = gl::Texture(m_gl, GL_RGBA32F, size);
            m_incoming_framebuffer = gl::create_framebuffer(m_gl, {&m_incoming});
            m_near_radiance = gl::Texture(m_gl, GL_RGBA16F, size);
            m_near_framebuffer = gl::create_framebuffer(m_gl, {&m_near_radiance});
            m_blur.resize(size);
        }
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        ALCOVE_ASSERT(inputs.lights != nullptr && inputs.raster != nullptr, "lights and a raster");
        const std::vector<VirtualLight> lights = place_lights(inputs, passes);
        for (const VirtualLight& light : lights) {
            add_light(inputs, light, passes);
        }
        LightSumSettings settings;
        settings.adds_surroundings = true;
        if (has_near_bounce()) {
            bounce_near(inputs, passes);
            settings.reflected = &m_near_radiance;
        }
        MethodOutput output;
        if (inputs.wants_visibility) {
            const auto pass = passes.scope("instant_radiosity/visibility");
            output.visibility = &m_sum.show_visibility(inputs, settings);
        }
        const auto pass = passes.scope("instant_radiosity/shade");
        output.radiance = &m_sum.shade(inputs, settings);
        return output;
    }

  private:
    [[nodiscard]] bool has_near_bounce() const { return m_params.near_bounce != NearBounce::off; }

    FullScreenProgram build(const std::string& pass, const std::string& outputs) {
        gl::GeneratedFiles files = m_parameters.generated_files();
        files["layer_counts.glsl"] = make_layer_counts(m_params.layers, 0, false);
        files["shadow_map_counts.glsl"] = make_shadow_map_counts(1);
        files["sample_set_counts.glsl"] =
            make_sample_set_counts(m_params.tile, m_params.near_samples);
        files["light_outputs.glsl"] = outputs;
        FullScreenProgram program(
            m_gl, make_method_shader_library(),
            "methods/instant_radiosity/instant_radiosity_" + pass + ".frag.glsl", files);
        m_parameters.connect(program.program());
        return program;
    }

    std::vector<VirtualLight> place_lights(const MethodInputs& inputs, PassRecorder& passes) {
        const BoundingSphere& sphere = inputs.raster->get_bounding_sphere();
        for (const ShadowLight& light : list_shadow_lights(*inputs.lights, sphere)) {
            const auto pass = passes.scope("instant_radiosity/rsm");
            m_rsms.add(*inputs.raster, light);
        }
        const auto pass = passes.scope("instant_radiosity/place");
        m_sum.begin(inputs.wants_visibility);
        return m_rsms.choose(m_params.vpls, inputs.noise_seed);
    }

    /// Along the light's normal: a spot whose cone is the map's angle of view.
    LightView look_from(const VirtualLight& light, const BoundingSphere& sphere) const {
        const double half_angle = m_params.angle * std::numbers::pi / 360.0;
        return look_along(PointLight{light.position, light.intensity,
                                     SpotCone{light.normal, 0.0, half_angle}, true},
                          sphere);
    }

    void add_light(const MethodInputs& inputs, const VirtualLight& light, PassRecorder& passes) {
        const std::array<LightView, 1> views{
            look_from(light, inputs.raster->get_bounding_sphere())};
        {
            const auto pass = passes.scope("instant_radiosity/shadow_map");
            m_maps.draw(*inputs.raster, views);
        }
        const auto pass = passes.scope("instant_radiosity/light");
        if (inputs.wants_visibility && !m_light_with_open) {
            m_light_with_open = build("light", "#define GIVES_OPEN\n");
        }
        const FullScreenProgram& program = inputs.wants_visibility ? *m_light_with_open : m_light;
        program.use();
        m_parameters.bind();
        bind_layered_surfaces(m_gl, program, inputs);
        m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
        m_maps.bind(program, inputs.view.camera, views);
        const Camera& viewer = inputs.view.camera;
        const glm::dmat3 view_from_world = glm::transpose(viewer.world_from_view);
        const glm::vec3 position(view_from_world * (light.position - viewer.position));
        const glm::vec3 normal(view_from_world * light.normal);
        m_gl.Uniform3f(program.location("light_position"), position.x, position.y, position.z);
        m_gl.Uniform3f(program.location("light_normal"), normal.x, normal.y, normal.z);
        m_gl.Uniform3f(program.location("light_intensity"), light.intensity.x, light.intensity.y,
                       light.intensity.z);
        m_sum.add(program);
    }

    void bounce_near(const MethodInputs& inputs, PassRecorder& passes) {
        {
            const auto pass = passes.scope("instant_radiosity/near_bounce");
            m_near.use();
            m_parameters.bind();
            m_near.program().bind_block("KernelBlock", kKernelBinding);
            m_gl.BindBufferBase(GL_UNIFORM_BUFFER, kKernelBinding, m_kernel.get());
            bind_layered_surfaces(m_gl, m_near, inputs);
            m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
            m_gl.BindTextureUnit(2, inputs.gbuffer.texture(Channel::direct_light).get());
            m_gl.Uniform1ui(m_near.location("noise_seed"), inputs.noise_seed);
            m_near.draw(m_incoming_framebuffer.get(), inputs.view.size);
        }
        const TileBlurSettings blur{m_params.blur ? m_params.tile : 1,
                                    m_params.blur_edge * m_params.radius};
        m_blur.render(inputs, blur, m_incoming, m_near_framebuffer.get(), true,
                      "instant_radiosity/near", passes);
    }

    const gl::Functions& m_gl;
    InstantRadiosityParams m_params;
    ParameterBlock m_parameters;
    LightSum m_sum;
    ReflectiveShadowMaps m_rsms;
    ShadowMaps m_maps; ///< of one virtual light after the other
    FullScreenProgram m_light;
    std::optional<FullScreenProgram> m_light_with_open; ///< compiled when it is first asked for
    FullScreenProgram m_near;
    TileBlur m_blur;
    gl::BufferHandle m_kernel;
    gl::Texture m_incoming; ///< of the near bounce: mean incoming radiance, and eye depth
    gl::FramebufferHandle m_incoming_framebuffer;
    gl::Texture m_near_radiance;
    gl::FramebufferHandle m_near_framebuffer;
};

} // namespace

std::unique_ptr<Method> make_instant_radiosity(const gl::Functions& gl,
                                               const InstantRadiosityParams& params,
                                               const ParameterTable& table,
                                               const ResolvedParameters& resolved) {
    return std::make_unique<InstantRadiosity>(gl, params, table, resolved);
}

} // namespace alcove
