#include "methods/reference_ray_traced/reference_ray_traced.hpp"

#include "methods/common/ray_tracer.hpp"
#include "methods/common/traced_target.hpp"

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = ReferenceRayTracedParams;
    return describe_parameters(
        "reference_ray_traced",
        {
            describe_target_radius(&P::radius),
            integer(&P::rays, "rays")
                .range(2, 16384)
                .log_scale()
                .unit("rays")
                .symbol("N")
                .meaning("Rays a pixel in all, in two independent halves; an odd number is rounded "
                         "down.")
                .source("ours"),
            describe_target_falloff(&P::falloff),
            describe_target_weighting(&P::weighting),
            describe_target_normals(&P::normals),
        });
}

class ReferenceRayTraced final : public Method {
  public:
    ReferenceRayTraced(const gl::Functions& gl, const ResolvedParameters& resolved)
        : m_gl(gl), m_params(make_table().bind<ReferenceRayTracedParams>(resolved)) {}

    MethodRequests get_requests() const override { return {{}, true}; }

    void resize(ImageSize size) override { m_visibility = gl::Texture(m_gl, GL_R32F, size); }

    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override {
        const auto pass = passes.scope("reference_ray_traced/trace");
        ALCOVE_ASSERT(inputs.geometry != nullptr, "posed geometry was requested");
        m_tracer.update(*inputs.geometry);
        TraceSettings settings;
        settings.target = {m_params.radius, m_params.falloff, m_params.weighting, m_params.normals};
        settings.rays_per_half = m_params.rays / 2;
        settings.seed = inputs.noise_seed;
        gl::write_texture(
            m_gl, m_visibility,
            compute_mean(m_tracer.trace(inputs.view.camera, inputs.view.size, settings)));
        return {&m_visibility, nullptr};
    }

  private:
    const gl::Functions& m_gl;
    ReferenceRayTracedParams m_params;
    RayTracer m_tracer;
    gl::Texture m_visibility;
};

} // namespace

MethodUnit reference_ray_traced_unit() {
    MethodUnit unit;
    unit.name = "reference_ray_traced";
    unit.title = "Ray-traced reference";
    unit.citation =
        "Embree 3 (Wald et al. Embree: a kernel framework for efficient CPU ray tracing. 2014), "
        "Owen-scrambled Sobol rays (Burley 2020)";
    unit.is_reference = true;
    unit.parameters = make_table();
    unit.presets = {{"default", "64 rays in each of two halves", {}, 1.0, 2.0, ""}};
    unit.plane_response = 1.0;
    unit.map_target = map_whole_target;
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<ReferenceRayTraced>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
