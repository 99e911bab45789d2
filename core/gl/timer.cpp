#include "core/gl/timer.hpp"

#include <algorithm>
#include <limits>

namespace alcove::gl {

std::string_view to_text(TimerMode mode) {
    constexpr std::array kNames{"time_elapsed",         "timestamp",        "timestamp_flush",
                                "timestamp_flush_both", "timestamp_finish", "fenced_wall"};
    return kNames.at(static_cast<std::size_t>(mode));
}

GLuint IntervalTimer::take_query(GLenum target) {
    if (m_used == m_queries.size()) {
        GLuint name = 0;
        m_gl->CreateQueries(target, 1, &name);
        m_queries.emplace_back(*m_gl, name);
    }
    return m_queries[m_used++].get();
}

void IntervalTimer::mark() {
    switch (m_mode) {
    case TimerMode::time_elapsed:
        ALCOVE_ASSERT(false, "time_elapsed has no marks");
        break;
    case TimerMode::timestamp:
        m_gl->QueryCounter(take_query(GL_TIMESTAMP), GL_TIMESTAMP);
        break;
    case TimerMode::timestamp_flush:
        m_gl->Flush();
        m_gl->QueryCounter(take_query(GL_TIMESTAMP), GL_TIMESTAMP);
        break;
    case TimerMode::timestamp_flush_both:
        m_gl->Flush();
        m_gl->QueryCounter(take_query(GL_TIMESTAMP), GL_TIMESTAMP);
        m_gl->Flush();
        break;
    case TimerMode::timestamp_finish:
        m_gl->Finish();
        m_gl->QueryCounter(take_query(GL_TIMESTAMP), GL_TIMESTAMP);
        // llvmpipe bins a query with the draws that follow it: unflushed, it would be read at their
        // last tile (0.13 of the true time in all six sequences).
        m_gl->Flush();
        break;
    case TimerMode::fenced_wall:
        m_gl->Finish();
        m_marks.push_back(Clock::now());
        break;
    }
}

void IntervalTimer::begin() {
    if (m_mode == TimerMode::time_elapsed) {
        m_gl->BeginQuery(GL_TIME_ELAPSED, take_query(GL_TIME_ELAPSED));
    } else {
        mark();
    }
}

void IntervalTimer::end() {
    if (m_mode == TimerMode::time_elapsed) {
        m_gl->EndQuery(GL_TIME_ELAPSED);
    } else {
        mark();
    }
}

std::vector<std::int64_t> IntervalTimer::collect() {
    m_gl->Finish();
    std::vector<std::int64_t> durations;
    const auto read = [this](std::size_t index) {
        GLuint64 value = 0;
        m_gl->GetQueryObjectui64v(m_queries[index].get(), GL_QUERY_RESULT, &value);
        return static_cast<std::int64_t>(value);
    };
    if (m_mode == TimerMode::time_elapsed) {
        for (std::size_t i = 0; i < m_used; ++i) {
            durations.push_back(read(i));
        }
    } else if (m_mode == TimerMode::fenced_wall) {
        for (std::size_t i = 0; i + 1 < m_marks.size(); i += 2) {
            durations.push_back(
                std::chrono::duration_cast<std::chrono::nanoseconds>(m_marks[i + 1] - m_marks[i])
                    .count());
        }
    } else {
        for (std::size_t i = 0; i + 1 < m_used; i += 2) {
            durations.push_back(read(i + 1) - read(i));
        }
    }
    m_used = 0;
    m_marks.clear();
    return durations;
}

double measure_tick_ns(const Functions& gl, TimerMode mode) {
    constexpr int kReadings = 2000;
    const auto read = [&gl, mode] {
        if (mode == TimerMode::fenced_wall) {
            const auto now = std::chrono::steady_clock::now().time_since_epoch();
            return static_cast<std::int64_t>(
                std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
        }
        GLint64 value = 0;
        gl.GetInteger64v(GL_TIMESTAMP, &value);
        return static_cast<std::int64_t>(value);
    };
    std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
    std::int64_t last = read();
    for (int i = 0; i < kReadings; ++i) {
        const std::int64_t now = read();
        if (now > last) {
            smallest = std::min(smallest, now - last);
        }
        last = now;
    }
    return static_cast<double>(smallest);
}

} // namespace alcove::gl
