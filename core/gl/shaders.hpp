#pragma once
// The GLSL files of core/gl.

#include "core/base/embedded_file.hpp"

namespace alcove {

/// Generated from the folder's .glsl files.
[[nodiscard]] std::span<const EmbeddedFile> embedded_gl_shaders();

} // namespace alcove
