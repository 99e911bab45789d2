#pragma once
// The GLSL that methods may include: their own, methods/common, core/frame and core/gl.

#include "core/gl/program.hpp"

namespace alcove {

[[nodiscard]] gl::ShaderLibrary make_method_shader_library();

} // namespace alcove
