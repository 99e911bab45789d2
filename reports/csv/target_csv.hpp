#pragma once
// targets.csv: one line a cell and target of every ranking. Columns: reports/README.md.

#include "reports/analysis/target_ranking.hpp"

#include <string>

namespace alcove {

/// The whole file; the header alone if the run has nothing to rank.
[[nodiscard]] std::string make_target_csv(const RunAnalysis& analysis);

/// Writes <run>/targets.csv atomically. Throws FailureError if it cannot be written.
void write_target_csv(const RunFolder& run, const RunAnalysis& analysis);

} // namespace alcove
