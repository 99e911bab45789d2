#pragma once
// The table a run ends with, as plain text.

#include "reports/analysis/analysis.hpp"

#include <filesystem>
#include <string>

namespace alcove {

/// Every finished round with its verdict and what it can tell apart, then the device and the page's
/// path. No colours and no control characters, also not out of labels. Ends with a line end.
[[nodiscard]] std::string make_terminal_report(const RunAnalysis& analysis,
                                               const std::filesystem::path& page);

} // namespace alcove
