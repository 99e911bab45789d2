#pragma once
// What methods that compute the whole of a target have in common: its parameters and their mapping.

#include "core/contract/method.hpp"

namespace alcove {

template <class P>
[[nodiscard]] ParameterBuilder describe_target_radius(double P::*field) {
    return real(field, "radius")
        .range(1e-4, 1e3)
        .log_scale()
        .unit("m")
        .symbol("r")
        .default_expression("scene_radius")
        .meaning("Length of the rays.")
        .source("target");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_target_falloff(Falloff P::*field) {
    return choice(field, "falloff", {"none", "linear", "quadratic"})
        .meaning("Weight of a hit at distance d: 1, 1 - d/r, 1 - (d/r)^2.")
        .source("target");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_target_weighting(Weighting P::*field) {
    return choice(field, "weighting", {"cosine", "uniform"})
        .meaning("Weight of a direction.")
        .source("target");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_target_normals(Normals P::*field) {
    return choice(field, "normals", {"shading", "geometric"})
        .meaning("Normal that spans the hemisphere.")
        .source("target");
}

/// Radius, falloff and weighting; with the G-buffer's or the vertices' shading normals.
[[nodiscard]] TargetMapping map_target_on_shading_normals(const Target& target);
/// Radius, falloff and normals; for light, whose directions weigh by their cosine.
[[nodiscard]] TargetMapping map_cosine_target(const Target& target);
/// All of it.
[[nodiscard]] TargetMapping map_whole_target(const Target& target);

} // namespace alcove
