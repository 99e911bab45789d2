#include "methods/shadow_correction/shadow_correction_renderer.hpp"

#include "methods/common/layered_surfaces.hpp"
#include "methods/common/light_sum.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/shaders.hpp"
#include "methods/common/shadow_light.hpp"
#include "methods/common/shadow_maps.hpp"
#include "methods/shadow_correction/environment_lights.hpp"

#include <cmath>
#include <map>
#include <utility>

#include <glm/matrix.hpp>

namespace alcove {
namespace {

class ShadowCorrection final : public Method {
  public:
    ShadowCorrection(const gl::Functions& gl, const ShadowCorrectionParams& params,
                     const ParameterTable& table, const ResolvedParameters& resolved)
        : m_gl(gl), m_params(params), m_parameters(gl, table, resolved), m_sum(gl),
          m_maps(gl, params.map_size), m_environment_maps(gl, params.environment_map_size) {}

    MethodRequests get_requests() const override {
        MethodRequests requests;
        requests.channels = {Channel::eye_depth, Channel::normal, Channel::albedo};
        requests.layers = m_params.layers;
        requests.part_channels = ChannelSet{Channel::eye_depth};
        return requests;
    }

    void resize(ImageSize size) override { m_sum.resize(size); }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        ALCOVE_ASSERT(inputs.lights != nullptr && inputs.raster != nullptr, "lights and a raster");
        const BoundingSphere& sphere = inputs.raster->get_bounding_sphere();
        {
            const auto pass = passes.scope("shadow_correction/clear");
            m_sum.begin(inputs.wants_visibility);
        }
        for (const ShadowLight& light : list_shadow_lights(*inputs.lights, sphere)) {
            add_light(inputs, light, m_maps, passes);
        }
        for (const DirectionalLight& light : list_environment_lights(*inputs.lights)) {
            add_light(inputs, make_shadow_light(light, sphere), m_environment_maps, passes);
        }
        LightSumSettings settings;
        settings.adds_surroundings = m_params.environment_lights == 0;
        settings.adds_surroundings_to_visibility = settings.adds_surroundings;
        MethodOutput output;
        output.replaces_direct_light = true;
        if (inputs.wants_visibility) {
            const auto pass = passes.scope("shadow_correction/visibility");
            output.visibility = &m_sum.show_visibility(inputs, settings);
        }
        const auto pass = passes.scope("shadow_correction/shade");
        output.radiance = &m_sum.shade(inputs, settings);
        return output;
    }

  private:
    /// Of lights with this many views; true: for a visibility image as well.
    using ProgramKey = std::pair<std::size_t, bool>;

    const FullScreenProgram& get_program(const ProgramKey& key) {
        const auto known = m_programs.find(key);
        if (known != m_programs.end()) {
            return known->second;
        }
        gl::GeneratedFiles files = m_parameters.generated_files();
        files["layer_counts.glsl"] = make_layer_counts(m_params.layers, 0, false);
        files["shadow_map_counts.glsl"] = make_shadow_map_counts(key.first);
        files["light_outputs.glsl"] = key.second ? "#define GIVES_OPEN\n" : "\n";
        FullScreenProgram program(m_gl, make_method_shader_library(),
                                  "methods/shadow_correction/shadow_correction_light.frag.glsl",
                                  files);
        m_parameters.connect(program.program());
        return m_programs.emplace(key, std::move(program)).first->second;
    }

    void add_light(const MethodInputs& inputs, const ShadowLight& light, ShadowMaps& maps,
                   PassRecorder& passes) {
        if (light.casts_shadow && m_params.maps) {
            const auto pass = passes.scope("shadow_correction/shadow_map");
            maps.draw(*inputs.raster, light.views);
        }
        const auto pass = passes.scope("shadow_correction/light");
        const FullScreenProgram& program =
            get_program({light.views.size(), inputs.wants_visibility});
        program.use();
        m_parameters.bind();
        bind_layered_surfaces(m_gl, program, inputs);
        m_gl.BindTextureUnit(1, inputs.gbuffer.texture(Channel::normal).get());
        maps.bind(program, inputs.view.camera, light.views);
        set_light(program, light, inputs.view.camera);
        m_sum.add(program);
    }

    void set_light(const FullScreenProgram& program, const ShadowLight& light,
                   const Camera& viewer) const {
        const glm::dmat3 view_from_world = glm::transpose(viewer.world_from_view);
        const glm::vec3 place(view_from_world *
                              (light.is_point ? light.place - viewer.position : light.place));
        m_gl.Uniform4f(program.location("light_place"), place.x, place.y, place.z,
                       light.is_point ? 1.0f : 0.0f);
        m_gl.Uniform3f(program.location("light_color"), light.color.x, light.color.y,
                       light.color.z);
        m_gl.Uniform1i(program.location("casts_shadow"), light.casts_shadow ? 1 : 0);
        const glm::vec3 axis(light.cone ? view_from_world * light.cone->direction
                                        : glm::dvec3(0.0));
        const double outer = light.cone ? std::cos(light.cone->outer_radians) : -2.0;
        m_gl.Uniform4f(program.location("light_axis"), axis.x, axis.y, axis.z,
                       static_cast<float>(outer));
        const double inner = light.cone ? std::cos(light.cone->inner_radians) : 1.0;
        m_gl.Uniform1f(program.location("light_inner_cosine"), static_cast<float>(inner));
    }

    /// In world axes; gathered anew only when the light from all around is another one.
    std::vector<DirectionalLight> list_environment_lights(const Lights& lights) {
        if (m_params.environment_lights == 0) {
            return {};
        }
        if (!m_is_gathered || m_environment != lights.environment || m_ambient != lights.ambient) {
            m_environment = lights.environment;
            m_ambient = lights.ambient;
            m_around = gather_environment_lights(lights, m_params.environment_lights);
            m_is_gathered = true;
        }
        std::vector<DirectionalLight> around = m_around;
        turn_environment_lights(around, lights.environment_turn_radians);
        return around;
    }

    const gl::Functions& m_gl;
    ShadowCorrectionParams m_params;
    ParameterBlock m_parameters;
    LightSum m_sum;
    ShadowMaps m_maps;
    ShadowMaps m_environment_maps;
    std::map<ProgramKey, FullScreenProgram> m_programs; ///< compiled when they are first needed
    std::vector<DirectionalLight> m_around;             ///< of the environment below, not turned
    bool m_is_gathered = false;
    std::shared_ptr<const Environment> m_environment;
    glm::vec3 m_ambient{0.0f};
};

} // namespace

std::unique_ptr<Method> make_shadow_correction(const gl::Functions& gl,
                                               const ShadowCorrectionParams& params,
                                               const ParameterTable& table,
                                               const ResolvedParameters& resolved) {
    return std::make_unique<ShadowCorrection>(gl, params, table, resolved);
}

} // namespace alcove
