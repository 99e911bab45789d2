#pragma once
// Times of GPU work. Which mode may be believed is decided by timer_validation.hpp in the running
// context: on Mesa's llvmpipe the plain queries are wrong by factors, because rasterisation is
// deferred.

#include "core/gl/handles.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <string_view>
#include <vector>

namespace alcove::gl {

/// From the cheapest to the dearest boundary.
enum class TimerMode {
    time_elapsed,         ///< one GL_TIME_ELAPSED query a pass
    timestamp,            ///< GL_TIMESTAMP at each end
    timestamp_flush,      ///< glFlush, GL_TIMESTAMP
    timestamp_flush_both, ///< glFlush, GL_TIMESTAMP, glFlush
    timestamp_finish,     ///< glFinish, GL_TIMESTAMP, glFlush
    fenced_wall,          ///< glFinish and the CPU's steady clock: the fallback, never validated
};
inline constexpr std::array kQueryModes{TimerMode::time_elapsed, TimerMode::timestamp,
                                        TimerMode::timestamp_flush, TimerMode::timestamp_flush_both,
                                        TimerMode::timestamp_finish};

[[nodiscard]] std::string_view to_text(TimerMode mode);

/// A row of intervals, one after the other, each from begin() to end(). They may not overlap.
class IntervalTimer {
  public:
    IntervalTimer(const Functions& gl, TimerMode mode) : m_gl(&gl), m_mode(mode) {}

    void begin();
    void end();
    /// Waits for the device and returns the durations in ns, in order, then starts anew. A negative
    /// or absurd difference is returned as it is: hiding it would hide a broken clock.
    [[nodiscard]] std::vector<std::int64_t> collect();
    [[nodiscard]] TimerMode mode() const noexcept { return m_mode; }

  private:
    using Clock = std::chrono::steady_clock;
    void mark();
    GLuint take_query(GLenum target);

    const Functions* m_gl;
    TimerMode m_mode;
    std::vector<QueryHandle> m_queries; ///< kept from frame to frame
    std::size_t m_used = 0;
    std::vector<Clock::time_point> m_marks;
};

/// Smallest difference in ns between two readings of the mode's clock that differ at all.
[[nodiscard]] double measure_tick_ns(const Functions& gl, TimerMode mode);

} // namespace alcove::gl
