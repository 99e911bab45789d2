#pragma once
// Where a round's wall time goes.

#include <chrono>

namespace alcove {

/// Adds the wall time of its life to a sum of seconds.
class WallTime {
  public:
    explicit WallTime(double& seconds) : m_seconds(seconds) {}
    ~WallTime() { m_seconds += std::chrono::duration<double>(Clock::now() - m_begin).count(); }
    WallTime(const WallTime&) = delete;
    WallTime& operator=(const WallTime&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double& m_seconds;
    Clock::time_point m_begin = Clock::now();
};

} // namespace alcove
