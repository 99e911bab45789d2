#pragma once
// The passes of statvo: tables, then one evaluation, or one for each batch of slices.

#include "methods/statvo/statvo_tables.hpp"

#include <array>

namespace alcove {

class StatvoRenderer final : public Method {
  public:
    StatvoRenderer(const gl::Functions& gl, const ResolvedParameters& resolved);
    [[nodiscard]] MethodRequests get_requests() const override;
    void resize(ImageSize size) override;
    [[nodiscard]] MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override;

  private:
    void evaluate(const MethodInputs& inputs, GLuint framebuffer);
    void evaluate_slices(const MethodInputs& inputs, PassRecorder& passes);

    const gl::Functions& m_gl;
    StatvoParams m_params;
    ParameterBlock m_parameters;
    StatvoLayerTables m_tables;
    FullScreenProgram m_evaluate;
    FullScreenProgram m_resolve;
    ImageSize m_size; ///< without border
    gl::Texture m_visibility;
    gl::FramebufferHandle m_framebuffer;
    /// Sums over the slices so far, read and written in turn.
    struct Sums {
        gl::Texture occlusion;
        gl::Texture samples;
        gl::FramebufferHandle framebuffer;
    };
    std::array<Sums, 2> m_sums;
};

} // namespace alcove
