#pragma once
// The two tables of a round as text and back. Columns: reports/README.md.

#include "reports/record/record.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// Numbers of metrics that are not finite become empty fields.
[[nodiscard]] std::string make_samples_csv(const std::vector<SampleRow>& rows);
[[nodiscard]] std::string make_metrics_csv(const std::vector<MetricRow>& rows);

/// Reads a round's table. Every row must belong to the round: its id, one of its cells (or
/// "harness"), a frame inside the named segment, a repeat below `repeats`. Throws InputError naming
/// `file`, the line and the column.
[[nodiscard]] std::vector<SampleRow> parse_samples_csv(std::string_view text, std::string_view file,
                                                       const RoundRecord& round, int repeats);
[[nodiscard]] std::vector<MetricRow> parse_metrics_csv(std::string_view text, std::string_view file,
                                                       const RoundRecord& round);

/// The cell of rows charged to nobody.
inline constexpr std::string_view kHarnessCell = "harness";

} // namespace alcove
