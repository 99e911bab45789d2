#include "methods/common/parameter_block.hpp"

#include "core/base/parameters_glsl.hpp"
namespace alcove {

ParameterBlock::ParameterBlock(const gl::Functions& gl, const ParameterTable& table,
                               const ResolvedParameters& resolved)
    : m_gl(gl), m_generated{{"parameters.glsl", make_glsl_parameters(table, resolved)}} {
    const std::vector<std::byte> bytes = pack_parameter_block(table, resolved);
    if (!bytes.empty()) {
        m_buffer = gl::create_buffer(gl, bytes);
    }
}

void ParameterBlock::connect(const gl::Program& program) const {
    program.bind_block("ParameterBlock", kBinding);
}

void ParameterBlock::bind() const {
    if (m_buffer) {
        m_gl.BindBufferBase(GL_UNIFORM_BUFFER, kBinding, m_buffer.get());
    }
}

} // namespace alcove
