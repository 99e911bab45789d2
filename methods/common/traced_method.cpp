#include "methods/common/traced_method.hpp"

namespace alcove {

void TracedMethod::resize(ImageSize size) {
    m_visibility = gl::Texture(m_gl, GL_R32F, size);
    if (m_images == TracedImages::visibility_and_radiance) {
        m_radiance = gl::Texture(m_gl, GL_RGBA16F, size);
    }
}

MethodOutput TracedMethod::render(const MethodInputs& inputs, PassRecorder& passes) {
    const auto pass = passes.scope(m_name + "/trace");
    ALCOVE_ASSERT(inputs.geometry != nullptr, "posed geometry was requested");
    const TracedFrame frame = trace(inputs);
    gl::write_texture(m_gl, m_visibility, frame.visibility);
    if (m_images == TracedImages::visibility) {
        return {&m_visibility, nullptr};
    }
    gl::write_texture(m_gl, m_radiance, frame.radiance);
    return {&m_visibility, &m_radiance};
}

} // namespace alcove
