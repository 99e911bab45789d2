#pragma once
// The passes of instant_radiosity: `rsm` for each light of the scene, `shadow_map` and `light` for
// each virtual light, `near_bounce` and its blur, `shade`.

#include "methods/instant_radiosity/instant_radiosity.hpp"

#include <memory>

namespace alcove {

[[nodiscard]] std::unique_ptr<Method> make_instant_radiosity(const gl::Functions& gl,
                                                             const InstantRadiosityParams& params,
                                                             const ParameterTable& table,
                                                             const ResolvedParameters& resolved);

} // namespace alcove
