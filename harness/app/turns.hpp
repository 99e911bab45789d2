#pragma once
// `run --turns`: a run that works only while it holds the turn, so that two of them can share a
// machine without disturbing each other (harness/app/ab_command.cpp gives the turns).

#include <string>
#include <string_view>

namespace alcove {

/// The protocol: the run writes "turn <what>\n" on standard output before every step, and takes
/// the step when it has read "go\n" from standard input.
inline constexpr std::string_view kTurnPrefix = "turn ";
inline constexpr std::string_view kGoLine = "go\n";

class Turns {
  public:
    explicit Turns(bool is_on) : m_is_on(is_on) {}
    /// Asks and waits; returns at once if turns are off. `what` is one line. Throws FailureError
    /// if standard input ends or says something else.
    void take(const std::string& what) const;

  private:
    bool m_is_on;
};

} // namespace alcove
