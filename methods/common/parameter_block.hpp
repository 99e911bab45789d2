#pragma once
// A method's parameters on their way into its shaders: `#include "parameters.glsl"` on one side,
// the uniform block's bytes on the other, both from the one table.

#include "core/base/parameters.hpp"
#include "core/gl/program.hpp"

namespace alcove {

class ParameterBlock {
  public:
    ParameterBlock(const gl::Functions& gl, const ParameterTable& table,
                   const ResolvedParameters& resolved);
    /// {"parameters.glsl", text}
    [[nodiscard]] const gl::GeneratedFiles& generated_files() const noexcept { return m_generated; }
    /// Once after a program is linked.
    void connect(const gl::Program& program) const;
    /// Before each draw.
    void bind() const;

  private:
    static constexpr GLuint kBinding = 0;
    const gl::Functions& m_gl;
    gl::GeneratedFiles m_generated;
    gl::BufferHandle m_buffer;
};

} // namespace alcove
