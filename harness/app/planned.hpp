#pragma once
// What the command line will have and does not have yet. It stands in --help under "planned" and
// exits 2.

#include <span>
#include <string>

namespace alcove {

struct Planned {
    const char* name;
    const char* meaning;
};

[[nodiscard]] std::span<const Planned> list_planned_verbs();
/// Flags of `run`.
[[nodiscard]] std::span<const Planned> list_planned_run_flags();

/// Throws InputError: "`name` is planned, not built yet".
[[noreturn]] void throw_planned(const std::string& name);

} // namespace alcove
