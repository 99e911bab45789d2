#pragma once
// Parameters that every method over the shared estimators declares alike: one text for all tables.

#include "core/base/parameters.hpp"
#include "methods/common/kernels.hpp"

namespace alcove {

inline constexpr const char* kMattausch2010 = "Mattausch et al. 2010";

template <class P>
[[nodiscard]] ParameterBuilder describe_radius(double P::*field) {
    return real(field, "radius")
        .range(1e-4, 1e3)
        .log_scale()
        .unit("m")
        .symbol("r")
        .default_expression("scene_radius")
        .meaning("Reach of the samples.")
        .source(kMattausch2010);
}

template <class P>
[[nodiscard]] ParameterBuilder describe_directions(KernelDirections P::*field) {
    return choice(field, "directions", {"uniform", "cosine"})
        .rebuild()
        .meaning("Directions uniform over the hemisphere, each hit weighted by 2 cos, or "
                 "distributed as the cosine with equal weights.")
        .source(kMattausch2010);
}

template <class P>
[[nodiscard]] ParameterBuilder describe_cut(double P::*field) {
    return real(field, "cut")
        .range(1.0, 4.0)
        .unit("r")
        .meaning("Surfaces farther than this from the receiver never count.")
        .source(kMattausch2010);
}

template <class P>
[[nodiscard]] ParameterBuilder describe_bias(double P::*field) {
    return real(field, "bias")
        .range(0.0, 4.0)
        .unit("half pixel footprints")
        .meaning("Depth bias along the receiver's tangent plane; 1 is exact for planes at any "
                 "tilt.")
        .source("ours");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_strength(double P::*field) {
    return real(field, "strength")
        .range(0.1, 10.0)
        .log_scale()
        .unit("1")
        .meaning(
            "Factor on occlusion; 1 is the estimate itself. What `tune` fits beside the radius.")
        .source("ours");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_border(KernelBorder P::*field) {
    return choice(field, "border", {"open", "clamp"})
        .rebuild()
        .meaning("Samples outside the image: never blocked, or compared with the nearest pixel.")
        .source("clamp: Mattausch et al. 2010");
}

} // namespace alcove
