#pragma once
// tradeoff.csv: one line a cell of every trade-off. Columns: reports/README.md.

#include "reports/analysis/tradeoff.hpp"

#include <string>

namespace alcove {

/// The whole file; the header alone if the run has no trade-off.
[[nodiscard]] std::string make_tradeoff_csv(const RunAnalysis& analysis);

/// Writes <run>/tradeoff.csv atomically. Throws FailureError if it cannot be written.
void write_tradeoff_csv(const RunFolder& run, const RunAnalysis& analysis);

} // namespace alcove
