#include "methods/statvo/statvo.hpp"

#include "methods/common/estimator_parameters.hpp"
#include "methods/common/unit_parts.hpp"
#include "methods/statvo/statvo_renderer.hpp"

namespace alcove {
namespace {

constexpr const char* kPaper = "Hendrickx et al. 2015";
constexpr const char* kAdaptive = "layering=adaptive";
constexpr const char* kUniform = "layering=uniform";

std::string cite(const std::string& section) {
    return kPaper + (", " + section);
}

/// Overrides of a published setting: tables of plain float32 as section 8 words them.
std::vector<ParameterOverride> make_paper_overrides(PresetSettings settings) {
    std::vector<ParameterOverride> overrides = make_overrides(settings);
    overrides.push_back({"numbers", "float32", Provenance::preset});
    return overrides;
}

std::vector<Preset> make_presets() {
    const char* const kCentred = "the surface lies in the middle of the box, so that a plane that "
                                 "faces the camera fills half of it";
    return {
        {"default",
         "4 adaptive layers, quarter-resolution tables, heights along the normal",
         {},
         1.0,
         2.0,
         ""},
        {"paper_fig6_one_layer", "one layer at full resolution: dark halos",
         make_paper_overrides({{"levels", "0"}, {"downsample", "1"}, {"tables", "all"}}), 1.0, 2.0,
         ""},
        {"paper_fig6_uniform_64", "64 uniform layers at full resolution",
         make_paper_overrides({{"layering", "uniform"}, {"slices", "64"}, {"downsample", "1"}}),
         1.0, 2.0, ""},
        {"paper_fig6_adaptive_4",
         "4 adaptive layers at full resolution, all seven tables: without section 7",
         make_paper_overrides({{"downsample", "1"}, {"tables", "all"}}), 1.0, 2.0, ""},
        {"paper_view_aligned", "figure 7 (a) and (b): 4 adaptive layers, heights along the view",
         make_paper_overrides({{"projection", "view_aligned"}, {"downsample", "1"}}), 1.0, 2.0, ""},
        {"paper_centred_box", "the view-aligned box as section 3.3 words it, about the surface",
         make_paper_overrides(
             {{"projection", "view_aligned"}, {"box", "centre"}, {"downsample", "1"}}),
         128.0, 128.0, kCentred},
        {"paper_fig8_quadrants", "4 regions a box",
         make_paper_overrides({{"regions", "four"}, {"downsample", "1"}}), 1.0, 2.0, ""},
        {"paper_table1_full", "table 1 and figure 13: full-resolution tables, differential",
         make_paper_overrides({{"downsample", "1"}}), 1.0, 2.0, ""},
        {"paper_table1_half", "table 1 and figure 9 (b): half-resolution tables",
         make_paper_overrides({{"downsample", "2"}}), 1.0, 2.0, ""},
        {"paper_quarter", "figures 9 (c), 11, 12, 14 and 15: quarter-resolution tables",
         make_paper_overrides({{"downsample", "4"}}), 1.0, 2.0, ""},
        {"peeled", "as default, with the second depth layer's samples: the authors' future work",
         make_overrides({{"source", "peeled"}}), 1.0, 2.0, ""},
    };
}

/// The share of a box that is filled has no falloff and no cosine.
TargetMapping map_target(const Target& target) {
    TargetMapping mapping;
    mapping.overrides = {{"radius", to_text(ParameterValue{target.radius_m}), Provenance::target}};
    mapping.reason = "falloff " + std::string(to_text(target.falloff)) + " and weighting " +
                     std::string(to_text(target.weighting)) +
                     " asked for, the filled share of a box computed";
    if (target.normals != Normals::shading) {
        mapping.reason += "; geometric normals asked for, the G-buffer's shading normals used";
    }
    return mapping;
}

} // namespace

ParameterTable make_statvo_table() {
    using P = StatvoParams;
    return describe_parameters(
        "statvo",
        {
            real(&P::radius, "radius")
                .range(1e-4, 1e3)
                .log_scale()
                .unit("m")
                .symbol("a")
                .default_expression("scene_radius")
                .meaning("Half the side of the box on the surface; not published.")
                .source(cite("section 3.3")),
            real(&P::height, "height")
                .range(1e-4, 1e3)
                .log_scale()
                .unit("m")
                .symbol("h")
                .default_expression("radius")
                .meaning("Height of the box over the surface; not published.")
                .source(cite("equation (7)")),
            choice(&P::layering, "layering", {"uniform", "adaptive"})
                .rebuild()
                .meaning("Slices of equal depth between the frame's nearest and farthest surface, "
                         "or layers split by the mean depth around each sample.")
                .source(cite("sections 4 and 5")),
            integer(&P::levels, "levels")
                .range(0, 3)
                .rebuild()
                .unit("splits")
                .symbol("d")
                .alive_with(kAdaptive)
                .meaning("Splits of the adaptive layers: 1, 2, 4 or 8 layers.")
                .source(cite("section 5")),
            integer(&P::slices, "slices")
                .range(1, 64)
                .rebuild()
                .unit("layers")
                .symbol("m")
                .alive_with(kUniform)
                .meaning("Uniform layers.")
                .source(cite("section 4")),
            choice(&P::projection, "projection", {"view_aligned", "normal"})
                .rebuild()
                .meaning("Heights along the view axis, or along the surface's normal.")
                .source(cite("equations (4) and (7)")),
            choice(&P::box, "box", {"surface", "centre"})
                .rebuild()
                .alive_with("projection=view_aligned")
                .meaning("Of the view-aligned box: its bottom on the surface, or the surface in "
                         "its middle. Along the normal the bottom lies on the surface.")
                .source(cite("section 3.3")),
            real(&P::drop, "drop")
                .range(0.25, 8.0)
                .log_scale()
                .unit("1")
                .symbol("k_psi")
                .meaning("How fast occlusion falls for means above the box's top: to nothing at "
                         "1 + 1/drop heights; not published.")
                .source(cite("figure 3")),
            choice(&P::regions, "regions", {"one", "four"})
                .rebuild()
                .meaning("The box as a whole, or its four quadrants by themselves, then the mean.")
                .source(cite("section 6")),
            integer(&P::downsample, "downsample")
                .range(1, 4)
                .rebuild()
                .unit("px")
                .symbol("f")
                .meaning("Pixels that one sample of the tables stands for, each way.")
                .source(cite("section 7.1")),
            choice(&P::tables, "tables", {"all", "differential"})
                .rebuild()
                .alive_with("downsample=1")
                .meaning("A table for each layer, or for every second one, the others as "
                         "differences.")
                .source(cite("section 7.2")),
            choice(&P::numbers, "numbers", {"float32", "float32_centred", "integer"})
                .rebuild()
                .meaning("What tables hold: sums of positions; of positions less the frame's mean "
                         "depth; or whole numbers that wrap around, exact within the largest box.")
                .source("float32: Hendrickx et al. 2015, section 8; ours"),
            choice(&P::source, "source", {"visible", "peeled"})
                .rebuild()
                .meaning("Samples of the depth buffer, or of its second layer as well (*authors' "
                         "future work*).")
                .source(cite("section 9")),
            real(&P::guard, "guard")
                .range(0.0, 10.0)
                .unit("%")
                .meaning("Width and height added on each side and cut off again.")
                .source(cite("section 8")),
            describe_strength(&P::strength),
        });
}

MethodUnit statvo_unit() {
    MethodUnit unit;
    unit.name = "statvo";
    unit.title = "Statistical volumetric obscurance";
    unit.citation = "Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical "
                    "volumetric obscurance. 2015";
    unit.parameters = make_statvo_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.map_target = map_target;
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<StatvoRenderer>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
