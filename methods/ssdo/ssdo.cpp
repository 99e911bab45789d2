#include "methods/ssdo/ssdo.hpp"

#include "methods/common/bounce_parameters.hpp"
#include "methods/common/estimator_parameters.hpp"
#include "methods/common/unit_parts.hpp"
#include "methods/ssdo/ssdo_renderer.hpp"

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = SsdoParams;
    return describe_parameters(
        "ssdo",
        {
            describe_radius(&P::radius).symbol("r_max").source(kRitschel2009),
            describe_set_samples(&P::samples).meaning("Samples a pixel and pass."),
            describe_tile(&P::tile),
            describe_fade(&P::fade),
            describe_border(&P::border),
            describe_bias(&P::bias),
            describe_thickness(&P::thickness),
            describe_layers(&P::layers)
                .meaning("Depth layers: 2 and 4 end solids where their backs are, and have them "
                         "send light."),
            integer(&P::views, "views")
                .range(0, static_cast<int>(kMostViews))
                .rebuild()
                .unit("cameras")
                .meaning("Further cameras, which look at the viewer's middle from the right, the "
                         "left, above and beyond.")
                .source(kRitschel2009),
            real(&P::view_spread, "view_spread")
                .range(0.05, 4.0)
                .rebuild()
                .unit("bounding radii")
                .meaning("How far further cameras are moved from the viewer.")
                .alive_with("views=4")
                .source("Ritschel et al. 2009; value ours"),
            real(&P::view_resolution, "view_resolution")
                .range(0.1, 1.0)
                .rebuild()
                .unit("1")
                .meaning("Sides of further cameras' images against the viewer's.")
                .alive_with("views=4")
                .source("Ritschel et al. 2009; value ours"),
            boolean(&P::bounce, "bounce")
                .rebuild()
                .meaning("One bounce of light from blockers.")
                .source(kRitschel2009),
            describe_sender_area(&P::bounce_strength, "bounce_strength")
                .meaning("Area of a sender's patch."),
            describe_sender_clamp(&P::distance_clamp, "distance_clamp")
                .default_expression("0.5*radius")
                .meaning("Least distance of a sender.")
                .source("Ritschel et al. 2009: 1; in radii: ours"),
            describe_tile_blur(&P::blur),
            describe_blur_edge(&P::blur_edge),
        });
}

std::vector<Preset> make_presets() {
    const char* const kNoBias = "no depth bias, as published: a tilted plane blocks itself";
    return {
        {"default", "16 samples in 4x4 sets, one bounce", {}, 1.0, 2.0, ""},
        {"direct", "without bounce", make_overrides({{"bounce", "false"}}), 1.0, 2.0, ""},
        {"paper_8", "as published: 8 samples, no bias, distances clamped to 1 unit",
         make_overrides({{"samples", "8"}, {"bias", "0"}, {"distance_clamp", "1"}}), 16.0, 16.0,
         kNoBias},
        {"paper_16", "as published: 16 samples, no bias, distances clamped to 1 unit",
         make_overrides({{"samples", "16"}, {"bias", "0"}, {"distance_clamp", "1"}}), 16.0, 16.0,
         kNoBias},
        {"peeled", "two depth layers", make_overrides({{"layers", "2"}}), 1.0, 2.0, ""},
        {"peeled_4", "four depth layers", make_overrides({{"layers", "4"}}), 1.0, 2.0, ""},
        {"four_views", "four further cameras at half resolution", make_overrides({{"views", "4"}}),
         1.0, 2.0, ""},
        {"converged", "the estimator's own limit: 256 samples, no blur",
         make_overrides({{"samples", "256"}, {"blur", "false"}}), 1.0, 2.0, ""},
    };
}

} // namespace

MethodUnit ssdo_unit() {
    MethodUnit unit;
    unit.name = "ssdo";
    unit.title = "Screen-space directional occlusion";
    unit.citation = "Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image "
                    "space. 2009";
    unit.parameters = make_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "converged";
    unit.map_target = map_linear_cosine_target;
    unit.count_samples = [](const ResolvedParameters& resolved) {
        const auto params = make_table().bind<SsdoParams>(resolved);
        return SampleCount{"ssdo/direct", double(params.samples)};
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return make_ssdo(context.functions(), make_table().bind<SsdoParams>(resolved), make_table(),
                         resolved);
    };
    return unit;
}

} // namespace alcove
