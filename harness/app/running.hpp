#pragma once
// What every verb that runs an experiment does: say what the plan leaves out, prove the clock, run
// with progress, and end with page and table.

#include "core/gl/context.hpp"
#include "core/gl/timer_validation.hpp"
#include "harness/app/turns.hpp"
#include "harness/run/plan.hpp"

namespace alcove {

/// The plan's warnings and what it skips, on standard error.
void print_notes(const MadePlan& plan);

/// The clocks that are right in this context.
[[nodiscard]] gl::TimerReport validate_clock(gl::Context& context);

/// The clock that a run was begun with, proved anew. On a busy machine a clock that is right can
/// fail, so it is tried again before that is said. Fenced wall time needs no proof. Another chosen
/// mode means that it failed.
[[nodiscard]] gl::TimerReport validate_clock_again(gl::Context& context,
                                                   const std::string& recorded);

/// Runs what is left of the run, rewrites its page as rounds finish, and prints its table.
void execute(RunFolder& run, gl::Context& context, gl::TimerMode mode, const Units& units,
             const Turns& turns);

} // namespace alcove
