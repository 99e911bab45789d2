#pragma once
// summary.csv: one line a round and cell, every number with its n and interval. Columns:
// reports/README.md.

#include "reports/analysis/analysis.hpp"

#include <string>

namespace alcove {

/// The whole file. Fields without a number are empty; the two anchors have lines of their own.
[[nodiscard]] std::string make_summary_csv(const RunAnalysis& analysis);

/// Writes <run>/summary.csv atomically. Throws FailureError if it cannot be written.
void write_summary_csv(const RunFolder& run, const RunAnalysis& analysis);

} // namespace alcove
