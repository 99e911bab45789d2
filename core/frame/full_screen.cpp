#include "core/frame/full_screen.hpp"

namespace alcove {

FullScreenProgram::FullScreenProgram(const gl::Functions& gl, const gl::ShaderLibrary& library,
                                     const std::string& fragment_file,
                                     const gl::GeneratedFiles& generated)
    : m_gl(&gl), m_program(gl::build_program(gl, library,
                                             {{GL_VERTEX_SHADER, "core/gl/full_screen.vert.glsl"},
                                              {GL_FRAGMENT_SHADER, fragment_file}},
                                             generated)) {
    GLuint name = 0;
    gl.CreateVertexArrays(1, &name);
    m_vertex_array = gl::VertexArrayHandle(gl, name);
}

void FullScreenProgram::draw(GLuint framebuffer, ImageSize size) const {
    m_gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    m_gl->Viewport(0, 0, size.width, size.height);
    m_gl->BindVertexArray(m_vertex_array.get());
    m_gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace alcove
