#include "methods/crytek_ssao/crytek_ssao_description.hpp"

#include "methods/common/estimator_parameters.hpp"
#include "methods/common/unit_parts.hpp"

namespace alcove {
namespace {

constexpr const char* kMittring = "Mittring 2007";
constexpr const char* kBlog = "\"Know your SSAO artifacts\" 2013";
using P = CrytekSsaoParams;

ParameterBuilder describe_kernel() {
    return choice(&P::kernel, "kernel",
                  {"sphere", "sphere_reflected", "hemisphere_gram_schmidt", "hemisphere_frame"})
        .rebuild()
        .meaning("Where samples lie: in the whole sphere; in the sphere, reflected about a random "
                 "vector and flipped to the normal's side; in the hemisphere, with a frame by "
                 "Gram-Schmidt of a random vector, or a fixed frame turned by a random angle.")
        .source("sphere: Mittring 2007; others: \"Know your SSAO artifacts\" 2013, the last ours");
}

ParameterBuilder describe_weighting() {
    return choice(&P::weighting, "weighting", {"uniform", "cosine"})
        .rebuild()
        .meaning("Directions count alike, as published, or as the cosine to the normal: by a "
                 "factor of 2 cos on a sphere's samples, by the distribution of a hemisphere's.")
        .source("uniform: Mittring 2007; cosine: ours");
}

ParameterBuilder describe_normalise() {
    return boolean(&P::normalise, "normalise")
        .rebuild()
        .alive_with("kernel=sphere")
        .meaning("Of kernel=sphere: an open plane, which hides half the sphere, is open; off, it "
                 "is 0.5, the grey look.")
        .source("ours; off: Mittring 2007");
}

ParameterBuilder describe_randomisation() {
    return choice(&P::randomisation, "randomisation", {"off", "tile", "pixel"})
        .rebuild()
        .meaning("Every pixel alike; 16 evenly spread random vectors, repeated every 4x4 texels; "
                 "a random vector a pixel.")
        .source("tile: Mittring 2007");
}

ParameterBuilder describe_min_cosine() {
    return real(&P::min_cosine, "min_cosine")
        .range(0.0, 0.5)
        .unit("1")
        .meaning("Least cosine of a sample's direction to the normal. A sphere's samples below it "
                 "are left out of the mean, a hemisphere's points are made without them.")
        .source(kBlog);
}

ParameterBuilder describe_range() {
    return real(&P::range, "range")
        .range(0.1, 10.0)
        .log_scale()
        .may_be_infinite()
        .unit("r")
        .meaning("How far before a sample a surface may lie that blocks it; 1 is the longest "
                 "sample, inf no range check.")
        .source(kBlog);
}

ParameterBuilder describe_indexing() {
    return choice(&P::indexing, "indexing", {"constant", "decoupled_literal", "decoupled"})
        .rebuild()
        .alive_with("kernel=hemisphere_frame,samples=4")
        .meaning("Sample j takes point j; direction and length of two points of `kernel_size`, by "
                 "one random number as published (11 pairs), or by one each (all pairs).")
        .source("decoupled_literal: \"Know your SSAO artifacts\" 2013; decoupled: ours");
}

ParameterBuilder describe_kernel_size() {
    return integer(&P::kernel_size, "kernel_size")
        .range(1, 64)
        .rebuild()
        .unit("points")
        .alive_with("indexing=decoupled")
        .meaning("Points of the set that decoupled samples are chosen from.")
        .source(kBlog);
}

ParameterBuilder describe_multiplier(int P::*field, const char* name, const char* of) {
    return integer(field, name)
        .range(1, 16)
        .rebuild()
        .unit("1")
        .alive_with("indexing=decoupled")
        .meaning(std::string("Factor on the index of ") + of +
                 ". Prime to kernel_size, or some are never used.")
        .source(kBlog);
}

ParameterBuilder describe_offsets() {
    return integer(&P::offsets, "offsets")
        .range(1, 64)
        .rebuild()
        .unit("values")
        .alive_with("indexing=decoupled_literal")
        .meaning("Values of the one random number, from 0. 18 modulo 11 favours 0 to 6.")
        .source(kBlog);
}

ParameterBuilder describe_msaa() {
    return choice(&P::msaa, "msaa", {"off", "pixel", "nearest_depth"})
        .inert("it is about the picture that visibility is composed into, not about visibility")
        .meaning("The picture: one sample a pixel, or 4, each with the visibility of its pixel, "
                 "or of that of the 3x3 pixels around whose depth is nearest to its own.")
        .source("pixel: \"Know your SSAO artifacts\" 2013; nearest_depth: ours");
}

} // namespace

ParameterTable make_crytek_table() {
    return describe_parameters(
        "crytek_ssao",
        {
            describe_radius(&P::radius).source(kMittring),
            describe_samples(&P::samples).source(kMittring),
            describe_kernel(),
            describe_weighting(),
            describe_normalise(),
            describe_randomisation(),
            describe_min_cosine(),
            describe_range(),
            describe_indexing(),
            describe_kernel_size(),
            describe_multiplier(&P::direction_multiplier, "direction_multiplier", "directions"),
            describe_multiplier(&P::length_multiplier, "length_multiplier", "lengths"),
            describe_offsets(),
            describe_bias(&P::bias),
            describe_border(&P::border).source("ours"),
            describe_strength(&P::strength),
            describe_resolution(&P::resolution),
            describe_upsample_width(&P::upsample_width),
            describe_blur_radius(&P::blur_radius).source(kBlog),
            describe_blur_edge(&P::blur_edge),
            describe_msaa(),
        });
}

std::vector<Preset> make_crytek_presets() {
    const char* const kNoBias = "no depth bias, as published: what the least cosine leaves of a "
                                "tilted plane's depth within a pixel (up to 1.2/255 at 60 degrees, "
                                "3.7/255 at 75)";
    const auto blog = [](PresetSettings more) {
        std::vector<ParameterOverride> overrides =
            make_overrides({{"weighting", "uniform"}, {"bias", "0"}, {"blur_radius", "0"}});
        for (const ParameterOverride& one : make_overrides(more)) {
            overrides.push_back(one);
        }
        return overrides;
    };
    const auto half = [](const char* samples, const char* width) {
        return make_overrides({{"samples", samples},
                               {"weighting", "uniform"},
                               {"resolution", "half"},
                               {"upsample_width", width}});
    };
    return {
        {"default",
         "16 samples, reflected and flipped, 4x4 random vectors, 7x7 cross-bilateral blur",
         {},
         1.0,
         2.0,
         ""},
        {"unfiltered", "as default without the blur: the control",
         make_overrides({{"blur_radius", "0"}}), 1.0, 2.0, ""},
        {"mittring",
         "the whole sphere without normals, 16 samples, 4x4 random vectors, range check, blur",
         make_overrides(
             {{"kernel", "sphere"}, {"weighting", "uniform"}, {"bias", "0"}, {"min_cosine", "0"}}),
         2.0, 2.0,
         "no depth bias: of a pair that a plane halves both points may lie behind a pixel, and "
         "then two open ones do not make up for it (1.3/255 at 45 degrees)"},
        {"paper_fig12",
         "point sampling of Hendrickx et al. 2015, figure 12: 17 samples, half resolution, 4x4 "
         "random vectors, 7x7 bilateral upsampling",
         half("17", "7"), 1.0, 2.0, ""},
        {"paper_fig14",
         "the same of figure 14: 16 samples, half resolution, 4x4 random vectors, 8x8 bilateral "
         "upsampling",
         half("16", "8"), 1.0, 2.0, ""},
        {"blog_spherical",
         "\"Know your SSAO artifacts\": points of the sphere reflected about a random vector, no "
         "blur as its pictures; 8 samples are ours",
         blog({{"samples", "8"}}), 2.0, 4.0, kNoBias},
        {"blog_gram_schmidt",
         "the same with the hemisphere by Gram-Schmidt: its kernel of 7 with clumped rotations",
         blog({{"kernel", "hemisphere_gram_schmidt"}, {"samples", "7"}}), 2.0, 4.0, kNoBias},
        {"blog_cones",
         "the same with 5 samples that sweep 5 cones about the normal, in a fixed frame",
         blog({{"kernel", "hemisphere_frame"}, {"samples", "5"}, {"randomisation", "pixel"}}), 2.0,
         4.0, kNoBias},
        {"blog_decoupled_literal",
         "the same with 4 samples of a set of 11, by one random number of 0 to 17, as printed",
         blog({{"kernel", "hemisphere_frame"},
               {"samples", "4"},
               {"randomisation", "pixel"},
               {"indexing", "decoupled_literal"}}),
         2.0, 4.0, kNoBias},
        {"blog_decoupled", "the same with a random number each for directions and lengths",
         blog({{"kernel", "hemisphere_frame"},
               {"samples", "4"},
               {"randomisation", "pixel"},
               {"indexing", "decoupled"}}),
         2.0, 4.0, kNoBias},
        {"converged", "the estimator's own limit: 512 samples, a random vector a pixel, no blur",
         make_overrides({{"samples", "512"}, {"randomisation", "pixel"}, {"blur_radius", "0"}}),
         1.0, 2.0, ""},
    };
}

} // namespace alcove
