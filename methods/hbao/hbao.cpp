#include "methods/hbao/hbao.hpp"

#include "methods/common/estimator_parameters.hpp"
#include "methods/common/unit_parts.hpp"

namespace alcove {
namespace {

constexpr const char* kBavoil2008 = "Bavoil et al. 2008";

ParameterTable make_table() {
    using P = HbaoParams;
    return describe_parameters(
        "hbao", {
                    describe_radius(&P::radius).alive_with("border=clamp"),
                    integer(&P::directions, "directions")
                        .range(1, 64)
                        .log_scale()
                        .rebuild()
                        .unit("directions")
                        .symbol("N_d")
                        .meaning("Directions on the screen.")
                        .source(kBavoil2008),
                    integer(&P::steps, "steps")
                        .range(1, 64)
                        .log_scale()
                        .rebuild()
                        .unit("samples")
                        .symbol("N_s")
                        .meaning("Samples a direction, evenly spaced over the projected radius.")
                        .source(kBavoil2008),
                    real(&P::angle_bias, "angle_bias")
                        .range(0.0, 60.0)
                        .unit("degrees")
                        .meaning("Horizons this little above the tangent do not count: coarse "
                                 "tessellation and depth steps.")
                        .source(kBavoil2008),
                    describe_rotation(&P::rotation),
                    boolean(&P::attenuation, "attenuation")
                        .rebuild()
                        .symbol("W")
                        .meaning("Weight 1 - (d/r)^2 of each rise of the horizon; else 1.")
                        .source(kBavoil2008),
                    describe_strength(&P::strength),
                    describe_border(&P::border),
                    describe_resolution(&P::resolution),
                    describe_blur_radius(&P::blur_radius),
                    describe_upsample_width(&P::upsample_width),
                    describe_blur_edge(&P::blur_edge),
                });
}

std::vector<Preset> make_presets() {
    return {
        {"default",
         "6 directions of 4 steps, 10 degrees of bias, 4x4 rotations, 7x7 blur",
         {},
         1.0,
         2.0,
         ""},
        {"unfiltered", "as default, without the blur: a control",
         make_overrides({{"blur_radius", "0"}}), 1.0, 2.0, ""},
        {"paper_bias", "30 degrees of bias, as the paper shows against creases of tessellation",
         make_overrides({{"angle_bias", "30"}}), 1.0, 2.0, ""},
        {"converged", "the estimator's own limit: 32 directions of 32 steps, no bias, no blur",
         make_overrides(
             {{"directions", "32"}, {"steps", "32"}, {"angle_bias", "0"}, {"blur_radius", "0"}}),
         1.0, 2.0, ""},
    };
}

} // namespace

MethodUnit hbao_unit() {
    MethodUnit unit;
    unit.name = "hbao";
    unit.title = "Horizon-based AO (classic)";
    unit.citation = "Bavoil, Sainz, Dimitrov. Image-space horizon-based ambient occlusion. 2008";
    unit.parameters = make_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = [](const Target& target) {
        TargetMapping mapping =
            map_radius(target, {.falloff = "quadratic", .weighting = "uniform"});
        if (target.falloff == Falloff::none) {
            mapping.overrides.push_back({"attenuation", "false", Provenance::target});
        }
        return mapping;
    };
    unit.count_samples = [](const ResolvedParameters& resolved) {
        const auto params = make_table().bind<HbaoParams>(resolved);
        return count_estimator_samples("hbao", params.directions * params.steps,
                                       params.resolution == EstimatorResolution::half);
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        const auto params = make_table().bind<HbaoParams>(resolved);
        const EstimatorRecipe recipe = make_estimator_recipe("hbao", params, {});
        return make_estimator_method(context.functions(), make_table(), resolved, recipe);
    };
    return unit;
}

} // namespace alcove
