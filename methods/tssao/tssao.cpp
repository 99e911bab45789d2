#include "methods/tssao/tssao.hpp"

#include "methods/common/estimator_parameters.hpp"
#include "methods/common/unit_parts.hpp"
#include "methods/tssao/tssao_renderer.hpp"

#include <algorithm>

namespace alcove {
namespace {

std::vector<ParameterOverride> make_published_overrides(PresetSettings more) {
    std::vector<ParameterOverride> overrides = make_overrides({{"directions", "uniform"},
                                                               {"bias", "0"},
                                                               {"border", "clamp"},
                                                               {"disocclusion", "relative"}});
    const std::vector<ParameterOverride> own = make_overrides(more);
    overrides.insert(overrides.end(), own.begin(), own.end());
    return overrides;
}

std::vector<Preset> make_presets() {
    const char* const kNoBias = "no depth bias, as published: a tilted plane blocks itself "
                                "(3.5/255 at 60 degrees, 6.2/255 at 75)";
    return {
        {"default",
         "hemisphere samples with equal weights, 32 a frame falling to 8, cap 1000, smooth "
         "invalidation, bias of half a pixel footprint, disocclusion test along the plane",
         {},
         1.0,
         2.0,
         ""},
        {"unfiltered", "as default, without the filter: a control",
         make_overrides({{"filter_radius", "0"}}), 1.0, 2.0, ""},
        {"paper_table2_sibenik",
         "Table 2, Sibenik: 32 samples a frame falling to 16; tolerances, estimator and kernel "
         "were not published",
         make_published_overrides({{"converged_samples", "16"}}), 4.0, 7.0, kNoBias},
        {"paper_table2_vienna",
         "Table 2, Vienna: 32 samples a frame falling to 8; the same gaps as above",
         make_published_overrides({{"converged_samples", "8"}}), 4.0, 7.0, kNoBias},
        {"paper_stills",
         "Figures 1 and 11: 32 samples a frame falling to 8, Fox and Compton's estimator (figure "
         "12 with estimator=hemisphere)",
         make_published_overrides({{"converged_samples", "8"}, {"estimator", "fox_compton"}}), 1.0,
         2.0, ""},
        {"reference_480",
         "what the estimator can do at most: 480 samples of the same table in one frame, no "
         "history, no filter, no rotation",
         make_overrides({{"use_history", "false"},
                         {"initial_samples", "480"},
                         {"filter_radius", "0"},
                         {"rotation_off_conv", "0"}}),
         1.0, 2.0, ""},
    };
}

} // namespace

ParameterTable make_tssao_table() {
    using P = TssaoParams;
    const char* const kTable1 = "Mattausch et al. 2010, table 1";
    const char* const kUnpublished = "Mattausch et al. 2010; value ours";
    return describe_parameters(
        "tssao",
        {
            choice(&P::estimator, "estimator", {"hemisphere", "fox_compton"})
                .rebuild()
                .meaning("Points in the hemisphere compared with the depth buffer, or surface "
                         "points on a disc on the screen weighted by their elevation.")
                .source("Mattausch et al. 2010, section 4"),
            describe_radius(&P::radius),
            integer(&P::initial_samples, "initial_samples")
                .range(1, 512)
                .log_scale()
                .unit("samples")
                .symbol("k1")
                .meaning("Samples a frame below `sample_switch_conv`.")
                .source(kTable1),
            integer(&P::converged_samples, "converged_samples")
                .range(1, 512)
                .log_scale()
                .unit("samples")
                .symbol("k2")
                .meaning("Samples a frame from there on.")
                .alive_with("history_cap=64")
                .source(kTable1),
            real(&P::history_cap, "history_cap")
                .range(1.0, 1e6)
                .log_scale()
                .may_be_infinite()
                .unit("samples")
                .symbol("n_max")
                .meaning("Most samples a history counts for.")
                .source(kTable1),
            real(&P::sample_switch_conv, "sample_switch_conv")
                .range(0.0, 1.0)
                .unit("convergence")
                .symbol("c_spatial")
                .meaning("Convergence at which k1 falls to k2.")
                .source(kTable1),
            real(&P::rotation_off_conv, "rotation_off_conv")
                .range(0.0, 1.0)
                .unit("convergence")
                .symbol("c_rot")
                .meaning("Convergence from which kernels are no longer turned by a random angle.")
                .source(kTable1),
            real(&P::filter_off_conv, "filter_off_conv")
                .range(0.01, 1.0)
                .unit("convergence")
                .symbol("c_adaptive")
                .meaning("Convergence at which the filter's support has shrunk to nothing.")
                .source(kTable1),
            integer(&P::filter_radius, "filter_radius")
                .range(0, 8)
                .rebuild()
                .unit("px")
                .symbol("F")
                .meaning("Taps on each side of the filter at convergence 0: 2 is 5x5, 4 is 9x9; 0 "
                         "is off.")
                .source(kTable1),
            real(&P::filter_sigma, "filter_sigma")
                .range(0.01, 10.0)
                .log_scale()
                .unit("r")
                .symbol("g")
                .meaning("Standard deviation of the filter's Gaussian, in the world.")
                .source(kUnpublished),
            boolean(&P::use_history, "use_history")
                .rebuild()
                .meaning("Off: every frame stands alone, as SSAO of the same samples.")
                .source("ours"),
            choice(&P::disocclusion, "disocclusion",
                   {"plane", "relative", "absolute", "post_projective"})
                .rebuild()
                .meaning("What a cached depth is held against: the receiver's plane at the texel, "
                         "or the receiver's own depth, relative, in metres or in steps of a "
                         "post-projective depth buffer.")
                .source("relative: Mattausch et al. 2010, eq. 7; absolute ones: what it replaces; "
                        "plane: ours"),
            real(&P::disocclusion_tolerance, "disocclusion_tolerance")
                .range(1e-4, 0.5)
                .log_scale()
                .unit("relative")
                .symbol("eps_d")
                .meaning("Largest difference of depth for `plane` and `relative`.")
                .source(kUnpublished),
            real(&P::disocclusion_distance, "disocclusion_distance")
                .range(1e-4, 100.0)
                .log_scale()
                .unit("m")
                .meaning("The same for `absolute`.")
                .alive_with("disocclusion=absolute")
                .source("ours"),
            real(&P::disocclusion_post_projective_step, "disocclusion_post_projective_step")
                .range(1e-8, 0.1)
                .log_scale()
                .unit("depth in [0,1]")
                .meaning("The same for `post_projective`.")
                .alive_with("disocclusion=post_projective")
                .source("ours"),
            choice(&P::invalidation, "invalidation", {"smooth", "full", "none"})
                .rebuild()
                .meaning("What happens where the neighbourhood has moved: the count falls to "
                         "`smooth_samples`, to 0, or nothing is tested.")
                .alive_with("smooth_samples=4")
                .source("Mattausch et al. 2010, section 3.6.1"),
            choice(&P::confidence, "confidence", {"binary", "graded"})
                .rebuild()
                .meaning("Graded: the count falls in proportion between one and two tolerances.")
                .alive_with("smooth_samples=4")
                .source("Mattausch et al. 2010, section 5 (future work)"),
            real(&P::smooth_samples, "smooth_samples")
                .range(1.0, 1024.0)
                .log_scale()
                .unit("samples")
                .symbol("n_smooth")
                .meaning("What smooth invalidation leaves; 32 to 64 published.")
                .source("Mattausch et al. 2010, section 3.6.1"),
            choice(&P::smooth_clamp, "smooth_clamp", {"before", "after"})
                .rebuild()
                .meaning("The count falls before new samples are merged, or only in what is kept.")
                .source("Mattausch et al. 2010 (both wordings occur)"),
            real(&P::neighbourhood_tolerance, "neighbourhood_tolerance")
                .range(0.001, 0.2)
                .log_scale()
                .unit("r")
                .symbol("eps_s")
                .meaning("Change of distance between receiver and sample that counts as motion; "
                         "never less than a pixel's footprint.")
                .alive_with("smooth_samples=4")
                .source(kUnpublished),
            boolean(&P::test_near_plane, "test_near_plane")
                .rebuild()
                .meaning("Also tests surface points up to 0.1 r behind the tangent plane, for "
                         "occluders that leave.")
                .alive_with("smooth_samples=4")
                .source("ours"),
            boolean(&P::top_up, "top_up")
                .rebuild()
                .meaning("A change found with k2 samples takes up to k1 in the same frame.")
                .alive_with("history_cap=64")
                .source("ours (the paper is silent)"),
            describe_directions(&P::directions),
            describe_cut(&P::cut),
            describe_bias(&P::bias),
            describe_border(&P::border),
            describe_strength(&P::strength),
            describe_grazing_cosine(&P::grazing_cosine).alive_with("estimator=fox_compton"),
            choice(&P::resolution, "resolution", {"full", "half"})
                .rebuild()
                .meaning("Half: all but the last pass at half width and height, then depth-aware "
                         "upsampling.")
                .source("Mattausch et al. 2010, section 4"),
            real(&P::guard, "guard")
                .range(0.0, 10.0)
                .unit("%")
                .meaning("Width and height added on each side and cut off again; 5 to 10 "
                         "published.")
                .source("Mattausch et al. 2010, section 3.6.3"),
            choice(&P::packing, "packing", {"separate", "packed"})
                .rebuild()
                .meaning("Depth and motion in two textures, or as one texel of four floats.")
                .alive_with("invalidation=none")
                .source("Mattausch et al. 2010, section 3.4.2"),
        });
}

int count_tssao_warm_frames(const TssaoParams& params) {
    if (!params.use_history) {
        return 0;
    }
    const double cap = std::min(params.history_cap, kTssaoLargestPublishedCap);
    int frames = 0;
    for (double count = 0.0; count < cap; ++frames) {
        count += count / cap < params.sample_switch_conv ? params.initial_samples
                                                         : params.converged_samples;
    }
    return frames;
}

MethodUnit tssao_unit() {
    MethodUnit unit;
    unit.name = "tssao";
    unit.title = "Temporal SSAO";
    unit.citation = "Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion "
                    "using temporal coherence. 2010";
    unit.parameters = make_tssao_table();
    unit.presets = make_presets();
    unit.plane_response = 1.0;
    unit.converged_preset = "reference_480";
    unit.map_target = map_linear_cosine_target;
    unit.warm_frames = [](const ResolvedParameters& resolved) {
        return count_tssao_warm_frames(make_tssao_table().bind<TssaoParams>(resolved));
    };
    unit.create = [](gl::Context& context, const ResolvedParameters& resolved) {
        return std::make_unique<TssaoRenderer>(context.functions(), resolved);
    };
    return unit;
}

} // namespace alcove
