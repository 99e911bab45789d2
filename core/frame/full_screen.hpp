#pragma once
// Full-screen passes.

#include "core/gl/program.hpp"

#include <string>

namespace alcove {

/// A fragment program that runs once a pixel.
class FullScreenProgram {
  public:
    FullScreenProgram() = default;
    FullScreenProgram(const gl::Functions& gl, const gl::ShaderLibrary& library,
                      const std::string& fragment_file, const gl::GeneratedFiles& generated = {});
    /// Makes the program current, for setting uniforms.
    void use() const { m_program.use(); }
    [[nodiscard]] GLint location(const char* name) const { return m_program.location(name); }
    [[nodiscard]] const gl::Program& program() const noexcept { return m_program; }
    /// Binds the framebuffer and draws over `size` pixels. The program must be current.
    void draw(GLuint framebuffer, ImageSize size) const;

  private:
    const gl::Functions* m_gl = nullptr;
    gl::Program m_program;
    gl::VertexArrayHandle m_vertex_array;
};

/// The GLSL files of core/frame and core/gl: what every method may include.
[[nodiscard]] std::span<const EmbeddedFile> embedded_frame_shaders();

} // namespace alcove
