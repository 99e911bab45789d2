#include "methods/volumetric_obscurance/volumetric_obscurance.hpp"

#include "methods/common/estimator_method.hpp"
#include "methods/common/estimator_parameters.hpp"
#include "methods/common/unit_parts.hpp"

namespace alcove {
namespace {

constexpr const char* kStatVo = "statistical volumetric obscurance, figure 13";

ParameterTable make_table() {
    using P = VolumetricObscuranceParams;
    return describe_parameters(
        "volumetric_obscurance",
        {
            describe_radius(&P::radius),
            describe_samples(&P::samples).source(kStatVo),
            choice(&P::domain, "domain", {"hemisphere", "ball"})
                .rebuild()
                .symbol("S")
                .meaning("Volume that the points are spread over: the half of the ball above the "
                         "surface, or all of it, half of which an open plane fills.")
                .source("Loos, Sloan 2010"),
            describe_rotation(&P::rotation),
            describe_cut(&P::cut),
            describe_bias(&P::bias),
            describe_border(&P::border),
            describe_strength(&P::strength),
            describe_blur_radius(&P::blur_radius),
            describe_blur_edge(&P::blur_edge).alive_with("blur_radius=2"),
        });
}

std::vector<Preset> make_presets() {
    return {
        {"default",
         "256 points in the half ball, no rotation, no blur: the StatVO paper's "
         "reference, its domain as the text allows where the normal is known",
         {},
         1.0,
         2.0,
         ""},
        {"ball", "256 points in the whole ball, as the definition is printed (equation 2)",
         make_overrides({{"domain", "ball"}}), 129.0, 129.0,
         "an open plane fills half of the ball: 0.5"},
        {"converged", "512 points in the half ball", make_overrides({{"samples", "512"}}), 1.0, 2.0,
         ""},
    };
}

} // namespace

MethodUnit volumetric_obscurance_unit() {
    MethodUnit unit;
    unit.name = "volumetric_obscurance";
    unit.title = "Volumetric obscurance by points";
    unit.citation = "Loos, Sloan. Volumetric obscurance. 2010, by points as the reference of "
                    "statistical volumetric obscurance";
    unit.parameters = make_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = [](const Target& target) {
        return map_radius(target, {.falloff = "none, but a share of volume",
                                   .weighting = "the same for every part of the volume"});
    };
    unit.count_samples = [](const ResolvedParameters& resolved) {
        const auto params = make_table().bind<VolumetricObscuranceParams>(resolved);
        return count_estimator_samples("volumetric_obscurance", params.samples, false);
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        const auto params = make_table().bind<VolumetricObscuranceParams>(resolved);
        EstimatorRecipe recipe;
        recipe.name = "volumetric_obscurance";
        recipe.kernel = make_ball_kernel(params.samples, params.domain == ObscuranceDomain::ball);
        recipe.blur_radius = params.blur_radius;
        recipe.edge_distance_m = params.blur_edge * params.radius;
        return make_estimator_method(context.functions(), make_table(), resolved, recipe);
    };
    return unit;
}

} // namespace alcove
