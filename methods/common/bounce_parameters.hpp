#pragma once
// Parameters of the light that surfaces on the screen send each other: one text for all tables.

#include "core/base/parameters.hpp"
#include "methods/common/estimator_parameters.hpp"

namespace alcove {

/// Add the meaning.
template <class P>
[[nodiscard]] ParameterBuilder describe_sender_area(double P::*field, const char* name) {
    return real(field, name)
        .range(0.0, 10.0)
        .unit("pi r_max^2 / N")
        .symbol("A_s")
        .source(kRitschel2009);
}

/// Add default expression, meaning and source.
template <class P>
[[nodiscard]] ParameterBuilder describe_sender_clamp(double P::*field, const char* name) {
    return real(field, name).range(1e-6, 1e3).log_scale().unit("m").symbol("d");
}

} // namespace alcove
