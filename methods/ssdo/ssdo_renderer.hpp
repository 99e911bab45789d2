#pragma once
// The passes of ssdo: `ssdo/send` for each deeper layer and further camera, `ssdo/direct`,
// `ssdo/bounce`, then `ssdo/blur_x` and `ssdo/blur_y`, or `ssdo/shade` without blur.

#include "methods/ssdo/ssdo.hpp"

#include <memory>

namespace alcove {

[[nodiscard]] std::unique_ptr<Method> make_ssdo(const gl::Functions& gl, const SsdoParams& params,
                                                const ParameterTable& table,
                                                const ResolvedParameters& resolved);

} // namespace alcove
