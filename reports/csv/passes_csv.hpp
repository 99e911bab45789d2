#pragma once
// passes.csv: one line a pass of every cell, with its time a pixel and a sample. Columns:
// reports/README.md.

#include "reports/analysis/analysis.hpp"

#include <string>

namespace alcove {

/// The whole file; the header alone if the run has no finished round.
[[nodiscard]] std::string make_passes_csv(const RunAnalysis& analysis);

/// Writes <run>/passes.csv atomically. Throws FailureError if it cannot be written.
void write_passes_csv(const RunFolder& run, const RunAnalysis& analysis);

} // namespace alcove
