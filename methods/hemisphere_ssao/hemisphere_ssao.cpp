#include "methods/hemisphere_ssao/hemisphere_ssao.hpp"

#include "methods/common/estimator_method.hpp"
#include "methods/common/estimator_parameters.hpp"
#include "methods/common/unit_parts.hpp"

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = HemisphereSsaoParams;
    return describe_parameters("hemisphere_ssao",
                               {
                                   describe_radius(&P::radius),
                                   describe_samples(&P::samples).source(kMattausch2010),
                                   describe_directions(&P::directions),
                                   describe_rotation(&P::rotation),
                                   describe_cut(&P::cut),
                                   describe_bias(&P::bias),
                                   describe_border(&P::border),
                                   describe_strength(&P::strength),
                                   describe_blur_radius(&P::blur_radius),
                                   describe_blur_edge(&P::blur_edge),
                               });
}

/// Without bias a plane darkens where its depth changes within a pixel: that is what the paper's
/// form does.
std::vector<Preset> make_presets() {
    const char* const kNoBias = "no depth bias, as published: a tilted plane blocks itself "
                                "(3.5/255 at 60 degrees, 6.2/255 at 75)";
    return {
        {"default",
         "16 cosine samples, weak blur, bias of half a pixel footprint",
         {},
         1.0,
         2.0,
         ""},
        {"unfiltered", "as default, without the blur: a control",
         make_overrides({{"blur_radius", "0"}}), 1.0, 2.0, ""},
        {"strong_blur", "as default, blurred over edges with a wider kernel",
         make_overrides({{"blur_radius", "4"}, {"blur_edge", "1"}}), 1.0, 2.0, ""},
        {"paper_weak_blur",
         "SSAO without history as Mattausch et al. 2010 compare with: 32 samples, high weight on "
         "discontinuities "
         "(kernel size not published, ours 5x5)",
         make_overrides({{"samples", "32"},
                         {"directions", "uniform"},
                         {"bias", "0"},
                         {"border", "clamp"},
                         {"blur_radius", "2"},
                         {"blur_edge", "0.05"}}),
         4.0, 7.0, kNoBias},
        {"paper_strong_blur",
         "the same with low weight on discontinuities (kernel size not published, ours 9x9)",
         make_overrides({{"samples", "32"},
                         {"directions", "uniform"},
                         {"bias", "0"},
                         {"border", "clamp"},
                         {"blur_radius", "4"},
                         {"blur_edge", "1"}}),
         4.0, 7.0, kNoBias},
        {"converged", "the estimator's own limit: 512 samples, no blur",
         make_overrides({{"samples", "512"}, {"blur_radius", "0"}}), 1.0, 2.0, ""},
    };
}

} // namespace

MethodUnit hemisphere_ssao_unit() {
    MethodUnit unit;
    unit.name = "hemisphere_ssao";
    unit.title = "Hemisphere SSAO";
    unit.citation =
        "Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion using temporal "
        "coherence. 2010 (its estimator, without history)";
    unit.parameters = make_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = map_linear_cosine_target;
    unit.count_samples = [](const ResolvedParameters& resolved) {
        const auto params = make_table().bind<HemisphereSsaoParams>(resolved);
        return count_estimator_samples("hemisphere_ssao", params.samples, false);
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        const auto params = make_table().bind<HemisphereSsaoParams>(resolved);
        EstimatorRecipe recipe;
        recipe.name = "hemisphere_ssao";
        recipe.kernel = make_hemisphere_kernel(params.samples, params.directions);
        recipe.blur_radius = params.blur_radius;
        recipe.edge_distance_m = params.blur_edge * params.radius;
        return make_estimator_method(context.functions(), make_table(), resolved, recipe);
    };
    return unit;
}

} // namespace alcove
