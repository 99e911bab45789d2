#pragma once
// Parameters of methods that correct shadow maps of their own in screen space: one text for all
// tables. The enumerators are those of methods/common/shadow_map.glsl.

#include "core/base/parameters.hpp"
#include "methods/common/estimator_parameters.hpp"

namespace alcove {

/// What a map's bias follows: nothing, the slope as published, or the slope up to 80 degrees and
/// one radius.
enum class MapBias { none, slope, clamped };

/// Sides of square shadow maps, up to `most` texels. Add meaning and source.
template <class P>
[[nodiscard]] ParameterBuilder describe_map_size(int P::*field, const char* name, int most) {
    return integer(field, name).range(16, most).log_scale().rebuild().unit("texels");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_map_bias(MapBias P::*field) {
    return choice(field, "bias", {"none", "slope", "clamped"})
        .symbol("b")
        .meaning("Of a map: none; p / 2 tan alpha; the same up to 80 degrees and one radius.")
        .source("Ritschel et al. 2009; limits ours");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_map_bias_scale(double P::*field) {
    return real(field, "bias_scale")
        .range(0.0, 4.0)
        .unit("p / 2")
        .meaning("Factor on the bias: 1 as published holds for slopes along a row of texels, 1.41 "
                 "along their diagonal; more allows for rounding.")
        .source("ours");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_correction(bool P::*field) {
    return boolean(field, "correction")
        .rebuild()
        .meaning("Samples between a point that its map calls lit and the light.")
        .source(kRitschel2009);
}

/// Add the meaning.
template <class P>
[[nodiscard]] ParameterBuilder describe_correction_samples(int P::*field) {
    return integer(field, "correction_samples")
        .range(1, 256)
        .log_scale()
        .rebuild()
        .unit("samples")
        .symbol("k")
        .source(kRitschel2009);
}

template <class P>
[[nodiscard]] ParameterBuilder describe_correction_layers(int P::*field) {
    return describe_layers(field).meaning(
        "Depth layers that the samples are compared with: 2 and 4 end solids where their backs "
        "are.");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_screen_bias(double P::*field) {
    return real(field, "screen_bias")
        .range(0.0, 4.0)
        .unit("half pixel footprints")
        .meaning("Depth bias of the screen-space test along the receiver's tangent plane; 1 is "
                 "exact for planes at any tilt.")
        .source("ours");
}

} // namespace alcove
