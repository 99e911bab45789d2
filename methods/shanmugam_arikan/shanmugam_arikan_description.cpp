#include "methods/shanmugam_arikan/shanmugam_arikan_description.hpp"

#include "methods/common/estimator_parameters.hpp"
#include "methods/common/unit_parts.hpp"
#include "methods/shanmugam_arikan/shanmugam_arikan.hpp"

#include <string>
#include <utility>
#include <vector>

namespace alcove {
namespace {

using P = ShanmugamArikanParams;

constexpr const char* kPaper = "Shanmugam, Arikan 2007";
constexpr const char* kUnpublished = "Shanmugam, Arikan 2007; value ours";

std::vector<ParameterBuilder> describe_near_part() {
    return {
        real(&P::r_far, "r_far")
            .range(1e-4, 1e3)
            .log_scale()
            .unit("m")
            .symbol("r_far")
            .default_expression("scene_radius / 2")
            .meaning("Reach of the near part.")
            .source(kUnpublished),
        integer(&P::samples, "samples")
            .range(1, 1024)
            .log_scale()
            .rebuild()
            .unit("samples")
            .meaning("Most neighbours of a pixel on each layer; as many as the projected reach "
                     "has pixels where it has fewer.")
            .source(kUnpublished),
        choice(&P::pattern, "pattern", {"logarithmic", "random", "square"})
            .rebuild()
            .meaning("Neighbours over the disc of the reach, as many from each doubling of the "
                     "distance or evenly spread; or every k-th pixel of the square around it.")
            .source("random, square: " + std::string(kPaper) + ", section 4.2; logarithmic: ours"),
        boolean(&P::rotation, "rotation")
            .rebuild()
            .meaning("Turns the random pattern by an angle a pixel.")
            .source(std::string(kPaper) + ", figure 4"),
        integer(&P::layers, "layers")
            .range(1, 4)
            .rebuild()
            .unit("layers")
            .meaning("Depth layers that neighbours are read from.")
            .source(std::string(kPaper) + ", section 4.2"),
        choice(&P::second, "second", {"peeled", "back_faces"})
            .rebuild()
            .meaning("What the second layer is: the next surface of each pixel, or the nearest "
                     "that is seen from behind. Back faces make two layers in all.")
            .alive_with("layers=3")
            .source(std::string(kPaper) + ", section 4.2 and figure 9"),
        real(&P::push_back, "push_back")
            .range(0.0, 4.0)
            .unit("r_i")
            .meaning("How far a neighbour's sphere is moved against its normal, so that planes do "
                     "not block themselves.")
            .source(kUnpublished),
    };
}

std::vector<ParameterBuilder> describe_far_part() {
    return {
        real(&P::epsilon, "epsilon")
            .range(0.001, 0.5)
            .log_scale()
            .unit("sr")
            .symbol("epsilon")
            .meaning("Occlusion below which a sphere is cut off, before `norm`.")
            .source(kUnpublished),
        real(&P::reach, "reach")
            .range(1e-3, 1e4)
            .log_scale()
            .may_be_infinite()
            .unit("m")
            .meaning("Spheres whose centre lies farther from the receiver do not count: what makes "
                     "the far part comparable with a target of finite radius.")
            .source("ours"),
        integer(&P::spheres, "spheres")
            .range(32, 10000)
            .log_scale()
            .unit("spheres")
            .meaning("Spheres over all objects, by their share of the area.")
            .source(std::string(kPaper) + ", section 5.3 (6000)"),
        choice(&P::members, "members", {"surface", "vertices"})
            .meaning("What spheres are clustered from: points spread evenly over the triangles, or "
                     "the vertices.")
            .source("vertices: " + std::string(kPaper) + ", figure 6"),
        choice(&P::radius_rule, "radius_rule", {"covering", "rms_ball", "rms_disc", "silhouette"})
            .meaning(
                "Radius of a sphere: to its farthest member, or that of the solid ball or the "
                "disc with the members' root mean square distance; or half the disc's, so that all "
                "spheres together show a quarter of the surface, as a closed convex body does "
                "on average.")
            .source("ours (the paper is silent)"),
        real(&P::sphere_push_back, "sphere_push_back")
            .range(0.0, 2.0)
            .unit("r |n|")
            .meaning("How far a sphere is moved against the mean normal of its members: by its "
                     "radius where they lie in a plane, not at all where they close around it.")
            .source("ours"),
        boolean(&P::far_from_r_far, "far_from_r_far")
            .rebuild()
            .meaning("Spheres whose centre lies within r_far do not count where the near part "
                     "does.")
            .source("ours"),
    };
}

} // namespace

ParameterTable make_shanmugam_arikan_table() {
    std::vector<ParameterTable::Entry> entries;
    const auto add = [&entries](const ParameterBuilder& builder) {
        entries.push_back(builder.entry());
    };
    add(choice(&P::part, "part", {"combined", "near", "far"})
            .rebuild()
            .meaning("Both parts added, or one alone.")
            .source(std::string(kPaper) + ", section 6"));
    for (const ParameterBuilder& builder : describe_near_part()) {
        add(builder);
    }
    for (const ParameterBuilder& builder : describe_far_part()) {
        add(builder);
    }
    add(choice(&P::norm, "norm", {"one", "pi", "two_pi"})
            .rebuild()
            .meaning("What the sum of equation (4), in steradians, is divided by.")
            .source("one: " + std::string(kPaper) + " as printed; pi: its equation (1)"));
    add(real(&P::inside_value, "inside_value")
            .range(0.0, 6.2831853)
            .unit("sr")
            .meaning("Occlusion of a receiver within a sphere, before `norm`; printed as 1.")
            .source(std::string(kPaper) + ", section 6"));
    add(choice(&P::blending, "blending", {"additive", "multiplicative"})
            .rebuild()
            .meaning("Spheres of the far part, and both parts: sums, or products of what each "
                     "leaves open.")
            .source("multiplicative: ours"));
    add(describe_strength(&P::strength));
    return {"shanmugam_arikan", std::move(entries)};
}

std::vector<Preset> make_shanmugam_arikan_presets() {
    return {
        {"default",
         "both parts, two peeled layers, 32 neighbours, 2000 spheres, epsilon 0.05",
         {},
         1.0,
         2.0,
         ""},
        {"near_only", "the image-space part alone (figure 5 e)", make_overrides({{"part", "near"}}),
         1.0, 2.0, ""},
        {"far_only", "the distant-occluder part alone (figure 6)",
         make_overrides({{"part", "far"}}), 1.0, 2.0, ""},
        {"paper_combined",
         "as printed where it is: two layers, 6000 spheres from vertices, 1 within a sphere "
         "(figure "
         "5 g); r_far, epsilon and the neighbours are not published",
         make_overrides({{"spheres", "6000"},
                         {"members", "vertices"},
                         {"inside_value", "1"},
                         {"pattern", "random"},
                         {"sphere_push_back", "0"},
                         {"far_from_r_far", "false"}}),
         90.0, 90.0,
         "the plane of the test is two triangles, all of whose points lie within the spheres of "
         "its "
         "corners"},
        {"back_faces", "the second layer from back faces (figure 9)",
         make_overrides({{"second", "back_faces"}}), 1.0, 2.0, ""},
        {"random", "neighbours evenly spread over the disc (figure 4)",
         make_overrides({{"pattern", "random"}}), 1.0, 2.0, ""},
        {"square", "every k-th pixel of a square (section 4.2)",
         make_overrides({{"pattern", "square"}}), 1.0, 2.0, ""},
        {"multiplicative", "against over-occlusion by many spheres",
         make_overrides({{"blending", "multiplicative"}}), 1.0, 2.0, ""},
        {"converged", "1024 neighbours a layer", make_overrides({{"samples", "1024"}}), 1.0, 2.0,
         ""},
    };
}

} // namespace alcove
