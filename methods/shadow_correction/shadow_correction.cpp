#include "methods/shadow_correction/shadow_correction.hpp"

#include "methods/common/shadow_parameters.hpp"
#include "methods/common/unit_parts.hpp"
#include "methods/shadow_correction/shadow_correction_renderer.hpp"

namespace alcove {
namespace {

ParameterTable make_table() {
    using P = ShadowCorrectionParams;
    return describe_parameters(
        "shadow_correction",
        {
            describe_radius(&P::radius)
                .symbol("r_max")
                .alive_with("environment_lights=8,segment=radius")
                .meaning("Largest distance of what blocks in screen space; limit of the clamped "
                         "bias; length of the segment `radius`.")
                .source(kRitschel2009),
            boolean(&P::maps, "maps")
                .rebuild()
                .alive_with("environment_lights=8")
                .meaning("Shadow maps; without them there is the screen alone.")
                .source(kRitschel2009),
            describe_map_size(&P::map_size, "map_size", 4096)
                .meaning("Side of the map of a light of the scene.")
                .source(kRitschel2009),
            describe_map_bias(&P::bias).alive_with("environment_lights=8,correction=false"),
            describe_map_bias_scale(&P::bias_scale)
                .alive_with("environment_lights=8,correction=false"),
            describe_correction(&P::correction).alive_with("environment_lights=8"),
            choice(&P::segment, "segment", {"bias", "radius"})
                .rebuild()
                .alive_with("environment_lights=8")
                .meaning("Where they lie: from the point as far as the map's bias reaches, or as "
                         "far as the radius.")
                .source(kRitschel2009),
            describe_correction_samples(&P::correction_samples)
                .alive_with("environment_lights=8,segment=radius")
                .meaning("Samples a pixel and light: 16 with one layer, 8 with more in figure 9."),
            describe_correction_layers(&P::layers)
                .alive_with("environment_lights=8,segment=radius"),
            describe_thickness(&P::thickness).alive_with("environment_lights=8,segment=radius"),
            describe_screen_bias(&P::screen_bias).alive_with("environment_lights=8,segment=radius"),
            integer(&P::environment_lights, "environment_lights")
                .range(0, 1024)
                .rebuild()
                .unit("lights")
                .meaning("Directional lights that the surroundings become, of equal energy; 0: "
                         "nothing blocks the light of the surroundings.")
                .source("Ritschel et al. 2009: 256"),
            describe_map_size(&P::environment_map_size, "environment_map_size", 2048)
                .alive_with("environment_lights=8")
                .meaning("Side of the map of a light of the surroundings.")
                .source(kRitschel2009),
        });
}

std::vector<Preset> make_presets() {
    return {
        {"default", "scene lights with maps, clamped bias and correction", {}, 1.0, 2.0, ""},
        {"uncorrected", "classic bias: acne gone, contact shadows gone",
         make_overrides({{"correction", "false"}}), 1.0, 2.0, ""},
        {"unbiased", "no bias: acne", make_overrides({{"bias", "none"}, {"correction", "false"}}),
         1.0, 2.0, ""},
        {"peeled", "figure 9: two layers, 8 samples",
         make_overrides({{"layers", "2"}, {"correction_samples", "8"}}), 1.0, 2.0, ""},
        {"environment_32", "32 lights of the surroundings with 256x256 maps, 8 samples each",
         make_overrides({{"environment_lights", "32"},
                         {"bias", "slope"},
                         {"environment_map_size", "256"},
                         {"correction_samples", "8"}}),
         1.0, 2.0, ""},
        {"paper_256", "figure 10: 256 lights of the surroundings, 512x512 maps, 8 samples each",
         make_overrides({{"environment_lights", "256"},
                         {"bias", "slope"},
                         {"bias_scale", "1"},
                         {"correction_samples", "8"}}),
         8.0, 8.0, "the bias as published leaves acne where a slope runs across a texel's corners"},
        {"segment", "figure 6: no maps, the screen alone, one layer",
         make_overrides({{"maps", "false"}, {"segment", "radius"}}), 1.0, 2.0, ""},
        {"segment_peeled", "figure 6: no maps, the screen alone, two layers",
         make_overrides({{"maps", "false"}, {"segment", "radius"}, {"layers", "2"}}), 1.0, 2.0, ""},
    };
}

/// Shadows know no falloff, and light weighs them.
TargetMapping map_shadow_target(const Target& target) {
    return map_radius(target, {"none", "by light"});
}

} // namespace

MethodUnit shadow_correction_unit() {
    MethodUnit unit;
    unit.name = "shadow_correction";
    unit.title = "Shadow maps corrected in screen space";
    unit.citation = "Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image "
                    "space. 2009";
    unit.parameters = make_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.map_target = map_shadow_target;
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return make_shadow_correction(context.functions(),
                                      make_table().bind<ShadowCorrectionParams>(resolved),
                                      make_table(), resolved);
    };
    return unit;
}

} // namespace alcove
