#pragma once
// The passes of shadow_correction: `shadow_correction/shadow_map` and `shadow_correction/light` for
// each light, then `shadow_correction/shade`.

#include "methods/shadow_correction/shadow_correction.hpp"

#include <memory>

namespace alcove {

[[nodiscard]] std::unique_ptr<Method> make_shadow_correction(const gl::Functions& gl,
                                                             const ShadowCorrectionParams& params,
                                                             const ParameterTable& table,
                                                             const ResolvedParameters& resolved);

} // namespace alcove
