#include "tests/stability/planted_method.hpp"

#include <cmath>
#include <utility>

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = PlantedParams;
    return describe_parameters("planted", {real(&P::radius, "radius")
                                               .range(1e-4, 1e3)
                                               .unit("m")
                                               .symbol("r")
                                               .default_expression("scene_radius")
                                               .meaning("Nothing.")
                                               .source("ours"),
                                           integer(&P::samples, "samples")
                                               .range(1, 512)
                                               .unit("samples")
                                               .symbol("n")
                                               .meaning("Nothing.")
                                               .source("ours"),
                                           real(&P::cap, "cap")
                                               .range(1.0, 1e6)
                                               .may_be_infinite()
                                               .unit("samples")
                                               .symbol("n_max")
                                               .meaning("Nothing.")
                                               .source("ours")});
}

class PlantedMethod final : public Method {
  public:
    PlantedMethod(const gl::Functions& gl, PlantedParams params, Plant plant)
        : m_gl(gl), m_params(params), m_plant(std::move(plant)) {}

    void resize(ImageSize size) override {
        m_visibility = gl::Texture(m_gl, GL_R32F, size);
        reset_history();
    }

    void reset_history() override {
        m_frames = 0;
        m_has_moved = false;
        m_has_seen_nan = false;
    }

    MethodOutput render(const MethodInputs& inputs, PassRecorder&) override {
        const Image depth = gl::read_texture(m_gl, inputs.gbuffer.texture(Channel::eye_depth), 1);
        const Image normal = gl::read_texture(m_gl, inputs.gbuffer.texture(Channel::normal), 3);
        m_has_moved =
            m_has_moved || inputs.view.camera.position != inputs.view.previous_camera.position;
        for (const float value : depth.values()) {
            m_has_seen_nan = m_has_seen_nan || std::isnan(value);
        }
        Image visibility(inputs.view.size, 1, 1.0f);
        m_plant({inputs.view, depth, normal, m_params, m_frames++, m_has_moved, m_has_seen_nan},
                visibility);
        gl::write_texture(m_gl, m_visibility, visibility);
        return {&m_visibility, nullptr};
    }

  private:
    const gl::Functions& m_gl;
    PlantedParams m_params;
    Plant m_plant;
    gl::Texture m_visibility;
    int m_frames = 0;
    bool m_has_moved = false;
    bool m_has_seen_nan = false;
};

} // namespace

MethodUnit make_planted_unit(Plant plant) {
    MethodUnit unit;
    unit.name = "planted";
    unit.title = "Planted";
    unit.parameters = make_table();
    unit.presets = {{"default", "", {}, 1.0, 2.0, ""}, {"converged", "", {}, 1.0, 2.0, ""}};
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = [](const Target& target) {
        TargetMapping mapping;
        mapping.overrides = {
            {"radius", to_text(ParameterValue{target.radius_m}), Provenance::target}};
        return mapping;
    };
    unit.warm_frames = [](const ResolvedParameters&) { return 1; };
    unit.create = [plant = std::move(plant)](gl::Context& context,
                                             const ResolvedParameters& resolved) {
        return std::make_unique<PlantedMethod>(context.functions(),
                                               make_table().bind<PlantedParams>(resolved), plant);
    };
    return unit;
}

void darken_surfaces(const PlantedFrame& frame, Image& visibility, float value) {
    for (std::size_t i = 0; i < visibility.values().size(); ++i) {
        if (!std::isinf(frame.depth.values()[i])) {
            visibility.values()[i] = value;
        }
    }
}

} // namespace alcove
