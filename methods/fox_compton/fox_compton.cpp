#include "methods/fox_compton/fox_compton.hpp"

#include "methods/common/estimator_parameters.hpp"
#include "methods/common/unit_parts.hpp"

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = FoxComptonParams;
    return describe_parameters("fox_compton",
                               {
                                   describe_radius(&P::radius).alive_with("border=clamp"),
                                   describe_samples(&P::samples).source(kMattausch2010),
                                   describe_rotation(&P::rotation),
                                   describe_cut(&P::cut),
                                   describe_grazing_cosine(&P::grazing_cosine),
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
        {"default", "16 samples, weak blur", {}, 1.0, 2.0, ""},
        {"unfiltered", "as default, without the blur: a control",
         make_overrides({{"blur_radius", "0"}}), 1.0, 2.0, ""},
        {"paper_weak_blur",
         "SSAO without history as Mattausch et al. 2010 compare with in figures 1 and 11: 32 "
         "samples (kernel size not published, ours 5x5)",
         make_overrides({{"samples", "32"}, {"blur_radius", "2"}, {"blur_edge", "0.05"}}), 1.0, 2.0,
         ""},
        {"paper_strong_blur",
         "the same with low weight on discontinuities (kernel size not published, ours 9x9)",
         make_overrides({{"samples", "32"}, {"blur_radius", "4"}, {"blur_edge", "1"}}), 1.0, 2.0,
         ""},
        {"converged", "the estimator's own limit: 512 samples, no blur",
         make_overrides({{"samples", "512"}, {"blur_radius", "0"}}), 1.0, 2.0, ""},
    };
}

} // namespace

MethodUnit fox_compton_unit() {
    MethodUnit unit;
    unit.name = "fox_compton";
    unit.title = "Fox-Compton disc SSAO";
    unit.citation = "Fox, Compton. Ambient occlusive crease shading. 2008, as Mattausch, Scherzer, "
                    "Wimmer 2010 use it";
    unit.parameters = make_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = [](const Target& target) {
        return map_radius(target, {.falloff = "linear in the distance to twice the radius",
                                   .weighting = "cosine"});
    };
    unit.count_samples = [](const ResolvedParameters& resolved) {
        const auto params = make_table().bind<FoxComptonParams>(resolved);
        return count_estimator_samples("fox_compton", params.samples,
                                       params.resolution == EstimatorResolution::half);
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        const auto params = make_table().bind<FoxComptonParams>(resolved);
        const EstimatorRecipe recipe =
            make_estimator_recipe("fox_compton", params, make_disc_kernel(params.samples));
        return make_estimator_method(context.functions(), make_table(), resolved, recipe);
    };
    return unit;
}

} // namespace alcove
