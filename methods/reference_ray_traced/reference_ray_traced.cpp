#include "methods/reference_ray_traced/reference_ray_traced.hpp"

#include "methods/common/ray_tracer.hpp"
#include "methods/common/traced_method.hpp"
#include "methods/common/traced_target.hpp"

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = ReferenceRayTracedParams;
    return describe_parameters("reference_ray_traced", {
                                                           describe_target_radius(&P::radius),
                                                           describe_reference_rays(&P::rays),
                                                           describe_target_falloff(&P::falloff),
                                                           describe_target_weighting(&P::weighting),
                                                           describe_target_normals(&P::normals),
                                                       });
}

class ReferenceRayTraced final : public TracedMethod {
  public:
    ReferenceRayTraced(const gl::Functions& gl, const ResolvedParameters& resolved)
        : TracedMethod(gl, "reference_ray_traced", TracedImages::visibility),
          m_params(make_table().bind<ReferenceRayTracedParams>(resolved)) {}

  private:
    TracedFrame trace(const MethodInputs& inputs) override {
        m_tracer.update(*inputs.geometry);
        TraceSettings settings;
        settings.target = {m_params.radius, m_params.falloff, m_params.weighting, m_params.normals};
        settings.rays_per_half = m_params.rays / 2;
        settings.seed = inputs.noise_seed;
        return {compute_mean(m_tracer.trace(inputs.view.camera, inputs.view.size, settings)), {}};
    }

    ReferenceRayTracedParams m_params;
    RayTracer m_tracer;
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
