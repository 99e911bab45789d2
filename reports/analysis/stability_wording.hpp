#pragma once
// How outcomes of hard cases are put for people, the same in the terminal and on the page.

#include "reports/record/stability_record.hpp"

#include <string>

namespace alcove {

/// "0.82" for a margin; "x" where it is minus infinity.
[[nodiscard]] std::string format_margin(double margin);

/// What stands in the matrix: "holds 0.82", "to 1000 m -3.1", "fails x", "n/a".
[[nodiscard]] std::string describe_outcome(const StabilityCaseRecord& described,
                                           const StabilityCellRecord& cell);

/// "5 of 8 methods hold in every case they apply to; 11 of 150 cells fail: a finding, not an
/// error."
[[nodiscard]] std::string summarize_stability(const StabilityRecord& record);

} // namespace alcove
