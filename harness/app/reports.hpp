#pragma once
// The reports that stand beside every run.

#include "reports/analysis/analysis.hpp"

#include <filesystem>
#include <vector>

namespace alcove {

/// Rewrites the page and, for finished rounds, its tables. `out` empty:
/// <run>/report.
void write_reports(const RunFolder& run, bool in_progress, std::vector<ProvisionalRow> provisional,
                   const std::filesystem::path& out = {});

/// Prints the terminal table on standard output.
void print_table(const RunFolder& run, const std::filesystem::path& out = {});

} // namespace alcove
