#pragma once
// Two runs with --turns, of which one works at a time: step by step in the order base new, new
// base, ..., so that what drifts falls on both alike.

#include "harness/run/piped_process.hpp"

#include <chrono>
#include <functional>
#include <string>

namespace alcove {

struct TurnSide {
    std::string side; ///< "base" or "new"
    std::string name; ///< for people
    PipedProcess& process;
};

/// One turn that is over.
struct Turn {
    std::string side;
    std::string step; ///< "repeat 3 r001-bunny"
    std::chrono::steady_clock::time_point begin;
    std::chrono::steady_clock::time_point end;
};

/// Gives turns until both have ended well. `turn_done` hears of each. Throws when one has not:
/// InputError if it refused its arguments, FailureError otherwise; what it said on standard error
/// is printed there. The other is left waiting.
void give_turns(const TurnSide& base, const TurnSide& next,
                const std::function<void(const Turn&)>& turn_done);

} // namespace alcove
