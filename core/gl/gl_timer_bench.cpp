#include "core/gl/gl_timer_bench.hpp"

#include "core/base/error.hpp"
#include "core/gl/shaders.hpp"

#include <limits>

namespace alcove::gl {
namespace {

/// Enough pixels for every thread of a rasteriser, few enough that the loop and not the memory is
/// timed.
constexpr ImageSize kSize{256, 256};
constexpr GLuint kGroupSide = 8;

} // namespace

GlTimerBench::GlTimerBench(const Functions& gl)
    : m_gl(&gl), m_draw_target(gl, GL_R32F, kSize), m_compute_target(gl, GL_R32F, kSize),
      m_framebuffer(create_framebuffer(gl, {&m_draw_target})) {
    const ShaderLibrary library{embedded_gl_shaders()};
    m_draw = build_program(gl, library,
                           {{GL_VERTEX_SHADER, "core/gl/full_screen.vert.glsl"},
                            {GL_FRAGMENT_SHADER, "core/gl/known_load.frag.glsl"}});
    m_compute = build_program(gl, library, {{GL_COMPUTE_SHADER, "core/gl/known_load.comp.glsl"}});
    GLuint name = 0;
    gl.CreateVertexArrays(1, &name);
    m_vertex_array = VertexArrayHandle(gl, name);
}

void GlTimerBench::set_iterations(LoadKind kind, std::int64_t iterations) {
    if (iterations > std::numeric_limits<GLint>::max()) {
        throw FailureError("timer validation", "the device is too fast for the known load");
    }
    (kind == LoadKind::draw ? m_draw_iterations : m_compute_iterations) =
        static_cast<GLint>(iterations);
}

void GlTimerBench::run(LoadKind kind) {
    const Functions& gl = *m_gl;
    if (kind == LoadKind::draw) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.get());
        gl.Viewport(0, 0, kSize.width, kSize.height);
        gl.BindVertexArray(m_vertex_array.get());
        m_draw.use();
        gl.Uniform1i(m_draw.location("iterations"), m_draw_iterations);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    } else {
        m_compute.use();
        gl.Uniform1i(m_compute.location("iterations"), m_compute_iterations);
        gl.BindImageTexture(0, m_compute_target.get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
        gl.DispatchCompute(kSize.width / kGroupSide, kSize.height / kGroupSide, 1);
    }
}

double GlTimerBench::run_alone(LoadKind kind) {
    using Clock = std::chrono::steady_clock;
    m_gl->Finish();
    const Clock::time_point begin = Clock::now();
    run(kind);
    m_gl->Finish();
    return std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
}

std::vector<double> GlTimerBench::run_sequence(TimerMode mode, std::span<const LoadKind> sequence) {
    m_gl->Finish();
    IntervalTimer timer(*m_gl, mode);
    for (const LoadKind kind : sequence) {
        timer.begin();
        run(kind);
        timer.end();
    }
    const std::vector<std::int64_t> durations = timer.collect();
    return {durations.begin(), durations.end()};
}

} // namespace alcove::gl
