#pragma once
// Parameters on their way to shaders: the GLSL text that declares them and the bytes of their
// block, from the one table.

#include "core/base/parameters.hpp"

#include <cstddef>

namespace alcove {

/// GLSL text of a set of values: a `const` for each `rebuild` parameter, one std140 block
/// `ParameterBlock` (all members four bytes wide, in table order) for the rest, and a `const int`
/// for every choice of an enumeration. Names get the prefix `param_`; `param_weighting_cosine` is a
/// choice's value.
[[nodiscard]] std::string make_glsl_parameters(const ParameterTable& table,
                                               const ResolvedParameters& resolved);
/// The bytes of that block, padded to 16; empty if every parameter is `rebuild`.
[[nodiscard]] std::vector<std::byte> pack_parameter_block(const ParameterTable& table,
                                                          const ResolvedParameters& resolved);

} // namespace alcove
