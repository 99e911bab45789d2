#include "harness/app/progress.hpp"

#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

namespace alcove {

Progress::Progress() : m_is_terminal(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (m_is_terminal) {
        std::fputs("\r\033[K", stderr);
    }
}

void Progress::show(double share, const std::string& what) {
    using std::chrono::duration;
    const Clock::time_point now = Clock::now();
    if (!m_is_terminal || now - m_last < std::chrono::milliseconds(200)) {
        return;
    }
    m_last = now;
    const double elapsed_s = duration<double>(now - m_begin).count();
    std::string left;
    // Before a twentieth is done the estimate is a guess.
    if (share > 0.05) {
        const double seconds = elapsed_s * (1.0 - share) / share;
        left = seconds < 90.0 ? fmt::format(", about {:.0f} s left", seconds)
                              : fmt::format(", about {:.0f} min left", seconds / 60.0);
    }
    const std::string line = fmt::format("\r\033[K[{:3.0f} %] {}{}", 100.0 * share, what, left);
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
}

} // namespace alcove
