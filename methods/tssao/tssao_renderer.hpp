#pragma once
// The passes of tssao and the textures that its history lives in.

#include "core/frame/full_screen.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/tssao/tssao.hpp"

#include <array>

namespace alcove {

class TssaoRenderer final : public Method {
  public:
    TssaoRenderer(const gl::Functions& gl, const ResolvedParameters& resolved);

    void set_effects(EffectSet effects) override;
    [[nodiscard]] MethodRequests get_requests() const override;
    void resize(ImageSize size) override;
    void reset_history() override { m_has_history = false; }
    [[nodiscard]] MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) override;

    /// What the last frame left: occlusion, count, index, eye depth (RGBA32F). For tests, which
    /// plant values there.
    [[nodiscard]] const gl::Texture& history() const { return m_buffers.at(m_latest).history; }

  private:
    /// One side of the ping-pong.
    struct HistoryBuffer {
        gl::Texture history;
        gl::FramebufferHandle framebuffer;       ///< history, visibility, depth mask
        gl::FramebufferHandle state_framebuffer; ///< the same with the history state
    };

    void accumulate(const MethodInputs& inputs, PassRecorder& passes);
    void filter(const MethodInputs& inputs, PassRecorder& passes) const;
    void resolve(const MethodInputs& inputs, PassRecorder& passes) const;
    /// Motion and eye depth come in one texel.
    [[nodiscard]] bool is_packed() const;
    [[nodiscard]] gl::GeneratedFiles make_generated_files(bool objects_may_move,
                                                          bool writes_state) const;
    [[nodiscard]] const gl::Texture& get_depth(const MethodInputs& inputs) const;
    /// Those that write the history state are compiled when they are first asked for: timed
    /// replays never do.
    const FullScreenProgram& get_accumulate_program(bool objects_may_move, bool writes_state);
    void allocate_state();

    const gl::Functions& m_gl;
    TssaoParams m_params;
    ParameterBlock m_parameters;
    EffectSet m_effects = EffectSet::all();
    std::array<FullScreenProgram, 4> m_accumulate; ///< [objects may move + 2 writes state]
    FullScreenProgram m_filter;
    FullScreenProgram m_resolve;
    gl::BufferHandle m_kernel;
    ImageSize m_size;      ///< of the output
    ImageSize m_work_size; ///< of the history: with border, halved at half resolution
    std::array<HistoryBuffer, 2> m_buffers;
    std::size_t m_latest = 0;
    bool m_has_history = false;
    gl::Texture m_visibility; ///< at the work size
    gl::Texture m_first;      ///< after the filter's first direction
    gl::Texture m_mask;       ///< depth: where the filter draws
    gl::Texture m_state;      ///< made when it is first asked for
    gl::Texture m_resolved;   ///< at the output's size; only where that differs
    gl::FramebufferHandle m_visibility_framebuffer;
    gl::FramebufferHandle m_first_framebuffer;
    gl::FramebufferHandle m_resolved_framebuffer;
};

} // namespace alcove
