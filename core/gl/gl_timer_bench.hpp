#pragma once
// The device side of timer validation: a fragment shader and a compute shader of known, adjustable
// cost.

#include "core/gl/program.hpp"
#include "core/gl/timer_validation.hpp"

namespace alcove::gl {

class GlTimerBench final : public TimerBench {
  public:
    explicit GlTimerBench(const Functions& gl);
    void set_iterations(LoadKind kind, std::int64_t iterations) override;
    double run_alone(LoadKind kind) override;
    std::vector<double> run_sequence(TimerMode mode, std::span<const LoadKind> sequence) override;
    double get_tick_ns(TimerMode mode) override { return measure_tick_ns(*m_gl, mode); }

  private:
    void run(LoadKind kind);

    const Functions* m_gl;
    Program m_draw;
    Program m_compute;
    Texture m_draw_target;
    Texture m_compute_target;
    FramebufferHandle m_framebuffer;
    VertexArrayHandle m_vertex_array;
    GLint m_draw_iterations = 1;
    GLint m_compute_iterations = 1;
};

} // namespace alcove::gl
