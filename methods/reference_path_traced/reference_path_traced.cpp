#include "methods/reference_path_traced/reference_path_traced.hpp"

#include "methods/common/traced_method.hpp"
#include "methods/common/traced_target.hpp"

#include <utility>

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = ReferencePathTracedParams;
    return describe_parameters(
        "reference_path_traced",
        {
            describe_target_radius(&P::radius),
            describe_reference_rays(&P::rays, " What they hit casts more."),
            describe_target_falloff(&P::falloff),
            choice(&P::reach, "reach", {"near", "full"})
                .meaning("What a hit brings: near, up to the radius its weight of the surface's "
                         "light and the rest of the surroundings'; full, the surface's light at "
                         "any distance, without radius and falloff.")
                .source("target"),
            integer(&P::bounces, "bounces")
                .range(0, 1)
                .unit("bounces")
                .meaning("0: surfaces that rays hit are black; 1: they send the light of lights "
                         "and environment on.")
                .source("Ritschel, Grosch, Seidel 2009"),
            describe_target_normals(&P::normals),
        });
}

class ReferencePathTraced final : public TracedMethod {
  public:
    ReferencePathTraced(const gl::Functions& gl, const ResolvedParameters& resolved)
        : TracedMethod(gl, "reference_path_traced", TracedImages::visibility_and_radiance),
          m_params(make_table().bind<ReferencePathTracedParams>(resolved)) {}

  private:
    TracedFrame trace(const MethodInputs& inputs) override {
        ALCOVE_ASSERT(inputs.lights != nullptr, "lights come with every frame");
        m_tracer.update(*inputs.geometry);
        PathSettings settings;
        settings.radius_m = m_params.radius;
        settings.falloff = m_params.falloff;
        settings.reach = m_params.reach;
        settings.normals = m_params.normals;
        settings.bounces = m_params.bounces;
        settings.rays_per_half = m_params.rays / 2;
        settings.seed = inputs.noise_seed;
        TracedRadiance traced =
            m_tracer.trace(inputs.view.camera, inputs.view.size, *inputs.lights, settings);
        return {std::move(traced.visibility), compute_mean(traced.indirect)};
    }

    ReferencePathTracedParams m_params;
    PathTracer m_tracer;
};

} // namespace

MethodUnit reference_path_traced_unit() {
    MethodUnit unit;
    unit.name = "reference_path_traced";
    unit.title = "Path-traced reference, one bounce";
    unit.citation =
        "Kajiya. The rendering equation. 1986; Embree 3 (Wald et al. Embree: a kernel framework "
        "for efficient CPU ray tracing. 2014); Owen-scrambled Sobol rays (Burley 2020)";
    unit.is_reference = true;
    unit.parameters = make_table();
    unit.presets = {{"default", "64 rays in each of two halves", {}, 1.0, 2.0, ""}};
    unit.plane_response = 1.0;
    unit.map_target = [](const Target& target) {
        TargetMapping mapping = map_cosine_target(target);
        mapping.overrides.push_back(
            {"reach", std::string(to_text(target.reach)), Provenance::target});
        return mapping;
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<ReferencePathTraced>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
