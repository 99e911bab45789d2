#pragma once
// One line on standard error with the share done and the time left; silent when that is no
// terminal.

#include <chrono>
#include <string>

namespace alcove {

class Progress {
  public:
    Progress();
    /// Wipes the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// `share` in [0,1]. Redraws at most five times a second.
    void show(double share, const std::string& what);

  private:
    using Clock = std::chrono::steady_clock;
    bool m_is_terminal;
    Clock::time_point m_begin = Clock::now();
    Clock::time_point m_last{};
};

} // namespace alcove
