#pragma once
// What a newcomer copies: the smallest whole method, with one pass and one parameter. Compiled and
// tested, never reported. It darkens surfaces that are turned away from the viewer, which is no
// occlusion at all.

#include "core/contract/method.hpp"

namespace alcove {

struct TemplateMethodParams {
    double strength = 0.5; ///< share of light that a surface seen edge-on loses, in [0,1]
};

[[nodiscard]] MethodUnit template_method_unit();

} // namespace alcove
