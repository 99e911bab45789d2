#pragma once
// The command line: verbs, their flags, and what is planned.

namespace alcove {

/// Runs the verb. Returns the exit code: 0 done, 3 a gate was not met. Throws Error for everything
/// else.
[[nodiscard]] int run_command_line(int argc, char** argv);

} // namespace alcove
