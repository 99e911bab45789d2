#pragma once
// explanation.csv: one line a cell, single frame and march. Columns: reports/README.md.

#include "reports/analysis/explanation.hpp"

#include <string>

namespace alcove {

/// The whole file; the header alone if no round was explained.
[[nodiscard]] std::string make_explanation_csv(const RunAnalysis& analysis);

/// Writes <run>/explanation.csv atomically. Throws FailureError if it cannot be written.
void write_explanation_csv(const RunFolder& run, const RunAnalysis& analysis);

} // namespace alcove
