#include "methods/common/shaders.hpp"

#include "core/frame/full_screen.hpp"
#include "core/gl/shaders.hpp"

namespace alcove {

/// Generated from the .glsl files of methods/.
std::span<const EmbeddedFile> embedded_method_shaders();

gl::ShaderLibrary make_method_shader_library() {
    return {embedded_method_shaders(), embedded_frame_shaders(), embedded_gl_shaders()};
}

} // namespace alcove
