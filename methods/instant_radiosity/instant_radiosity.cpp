#include "methods/instant_radiosity/instant_radiosity.hpp"

#include "methods/common/bounce_parameters.hpp"
#include "methods/common/unit_parts.hpp"
#include "methods/instant_radiosity/instant_radiosity_renderer.hpp"

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = InstantRadiosityParams;
    return describe_parameters(
        "instant_radiosity",
        {
            describe_radius(&P::radius)
                .symbol("r_max")
                .meaning("Reach of the near bounce; largest distance of what blocks in screen "
                         "space; limit of the clamped bias.")
                .source(kRitschel2009),
            integer(&P::vpls, "vpls")
                .range(1, 1024)
                .log_scale()
                .rebuild()
                .unit("lights")
                .meaning("Virtual point lights, of equal luminance, over all lights of the scene.")
                .source(kRitschel2009),
            describe_map_size(&P::rsm_size, "rsm_size", 2048)
                .meaning("Side of the reflective shadow map of a light of the scene.")
                .source("ours"),
            describe_map_size(&P::map_size, "map_size", 1024)
                .meaning("Side of a virtual light's shadow map.")
                .source("Ritschel et al. 2009; value ours"),
            real(&P::angle, "angle")
                .range(90.0, 170.0)
                .unit("degrees")
                .meaning("Of a virtual light's shadow map, one perspective view along its normal; "
                         "what lies beyond has no map.")
                .source("ours"),
            real(&P::clamp, "clamp")
                .range(1e-4, 1e3)
                .log_scale()
                .unit("m")
                .default_expression("radius")
                .meaning("Least distance of a virtual light in its form factor.")
                .source("Ritschel et al. 2009; value ours"),
            describe_map_bias(&P::bias),
            describe_map_bias_scale(&P::bias_scale),
            describe_correction(&P::correction),
            describe_correction_samples(&P::correction_samples)
                .meaning("Samples a pixel and virtual light."),
            describe_correction_layers(&P::layers),
            describe_thickness(&P::thickness),
            describe_screen_bias(&P::screen_bias),
            choice(&P::near_bounce, "near_bounce", {"off", "clamped_part", "added"})
                .rebuild()
                .meaning("Bounce of near surfaces on screen: none; what the clamp takes from the "
                         "virtual lights; all of it, which counts near surfaces twice.")
                .source("added: Ritschel et al. 2009; clamped_part: ours"),
            describe_set_samples(&P::near_samples, "near_samples")
                .meaning("Samples a pixel of the near bounce."),
            describe_sender_area(&P::near_strength, "near_strength")
                .meaning("Area of a sender's patch in the near bounce."),
            describe_sender_clamp(&P::near_clamp, "near_clamp")
                .default_expression("0.1*clamp")
                .meaning("Least distance of a sender in the near bounce.")
                .source("Ritschel et al. 2009: 1; value ours"),
            describe_tile(&P::tile),
            describe_fade(&P::fade),
            describe_tile_blur(&P::blur),
            describe_blur_edge(&P::blur_edge),
        });
}

std::vector<Preset> make_presets() {
    return {
        {"default",
         "virtual lights, corrected maps, near bounce of the clamped part",
         {},
         1.0,
         2.0,
         ""},
        {"uncorrected", "the classic bias alone, no near bounce",
         make_overrides({{"correction", "false"}, {"near_bounce", "off"}}), 1.0, 2.0, ""},
        {"paper_256", "figures 11 and 12: 256 virtual lights, the near bounce plainly added",
         make_overrides({{"vpls", "256"}, {"bias", "slope"}, {"near_bounce", "added"}}), 1.0, 2.0,
         ""},
        {"peeled", "two depth layers", make_overrides({{"layers", "2"}}), 1.0, 2.0, ""},
    };
}

/// Virtual lights reach everywhere, and light weighs them.
TargetMapping map_bounce_target(const Target& target) {
    return map_radius(target, {"none", "by light"});
}

} // namespace

MethodUnit instant_radiosity_unit() {
    MethodUnit unit;
    unit.name = "instant_radiosity";
    unit.title = "Instant radiosity corrected in screen space";
    unit.citation = "Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image "
                    "space. 2009; Keller. Instant radiosity. 1997";
    unit.parameters = make_table();
    unit.presets = make_presets();
    // None: virtual lights on a plane send nothing along it.
    unit.map_target = map_bounce_target;
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return make_instant_radiosity(context.functions(),
                                      make_table().bind<InstantRadiosityParams>(resolved),
                                      make_table(), resolved);
    };
    return unit;
}

} // namespace alcove
