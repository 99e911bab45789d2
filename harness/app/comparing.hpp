#pragma once
// What `compare` and `ab` do with two run folders: compare, write, print, gate.

#include "reports/analysis/comparison.hpp"

#include <filesystem>
#include <string>

namespace CLI {
class App;
} // namespace CLI

namespace alcove {

struct GateFlags {
    std::string gate; ///< empty: none; "worse" or "strict"
    std::string margin;
};

/// Adds --gate[=strict] and --margin F.
void add_gate_flags(CLI::App& app, GateFlags& flags);

/// Options as the flags ask. Throws InputError on a margin outside [0,1) or another gate.
[[nodiscard]] ComparisonOptions read_gate_flags(const GateFlags& flags);

/// Prints the table on standard output, warns of unknown verdicts on standard error, and writes
/// comparison.{csv,md,html} into `out` unless it is empty. Returns the exit code: 3 if the gate is
/// not met.
[[nodiscard]] int report_comparison(const Comparison& comparison, const GateFlags& flags,
                                    const std::filesystem::path& out);

} // namespace alcove
