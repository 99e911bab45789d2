#include "methods/line_sampling/line_sampling.hpp"

#include "methods/common/estimator_parameters.hpp"
#include "methods/common/unit_parts.hpp"

namespace alcove {
namespace {

constexpr const char* kLoos2010 = "Loos, Sloan 2010";

ParameterTable make_table() {
    using P = LineSamplingParams;
    return describe_parameters(
        "line_sampling",
        {
            describe_radius(&P::radius).alive_with("border=clamp"),
            describe_samples(&P::samples).source(kLoos2010),
            choice(&P::domain, "domain", {"hemisphere", "ball"})
                .rebuild()
                .meaning("Part of the ball that lines run through: above the surface's tangent "
                         "plane, or all of it, half of which an open plane fills.")
                .source(kLoos2010),
            choice(&P::outliers, "outliers", {"solid", "skipped", "paired"})
                .rebuild()
                .meaning("A surface nearer than the ball: fills its line, is left out, or is "
                         "replaced by the opposite line of its pair.")
                .source(kLoos2010),
            describe_rotation(&P::rotation),
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
        {"default", "12 lines in the half ball, 4x4 rotations, 7x7 blur", {}, 1.0, 2.0, ""},
        {"unfiltered", "as default, without the blur: a control",
         make_overrides({{"blur_radius", "0"}}), 1.0, 2.0, ""},
        {"paper_statvo_fig11",
         "StatVO figure 11 by its caption: 11 lines at full resolution, 4x4 rotations, 8x8 "
         "bilateral blur (ours 9x9: the blur has a centre)",
         make_overrides({{"samples", "11"}, {"blur_radius", "4"}}), 1.0, 2.0, ""},
        {"paper_statvo_fig11_text", "the same by its text: 8 lines",
         make_overrides({{"samples", "8"}, {"blur_radius", "4"}}), 1.0, 2.0, ""},
        {"paper_statvo_fig12",
         "StatVO figure 12: 12 lines at half resolution, 4x4 rotations, 7x7 bilateral upsampling",
         make_overrides({{"samples", "12"}, {"resolution", "half"}, {"upsample_width", "7"}}), 1.0,
         2.0, ""},
        {"ball", "the whole ball, without normals", make_overrides({{"domain", "ball"}}), 130.0,
         140.0,
         "an open plane fills half of the ball, and of a tilted one's the view rays measure "
         "another "
         "part than the disc's points"},
        {"converged", "the estimator's own limit: 512 lines, no blur",
         make_overrides({{"samples", "512"}, {"blur_radius", "0"}}), 1.0, 2.0, ""},
    };
}

} // namespace

MethodUnit line_sampling_unit() {
    MethodUnit unit;
    unit.name = "line_sampling";
    unit.title = "Line-sampled volumetric obscurance";
    unit.citation = "Loos, Sloan. Volumetric obscurance. 2010";
    unit.parameters = make_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = [](const Target& target) {
        return map_radius(target, {.falloff = "none, but a share of volume",
                                   .weighting = "the same for every part of the volume"});
    };
    unit.count_samples = [](const ResolvedParameters& resolved) {
        const auto params = make_table().bind<LineSamplingParams>(resolved);
        return count_estimator_samples("line_sampling", params.samples,
                                       params.resolution == EstimatorResolution::half);
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        const auto params = make_table().bind<LineSamplingParams>(resolved);
        const EstimatorRecipe recipe =
            make_estimator_recipe("line_sampling", params, make_paired_disc_kernel(params.samples));
        return make_estimator_method(context.functions(), make_table(), resolved, recipe);
    };
    return unit;
}

} // namespace alcove
