#pragma once
// strata.csv: one line a cell, state, metric and stratum. Columns: reports/README.md.

#include "reports/analysis/analysis.hpp"

#include <string>

namespace alcove {

/// The whole file; the header alone if no strata were measured.
[[nodiscard]] std::string make_strata_csv(const RunAnalysis& analysis);

/// Writes <run>/strata.csv atomically. Throws FailureError if it cannot be written.
void write_strata_csv(const RunFolder& run, const RunAnalysis& analysis);

} // namespace alcove
