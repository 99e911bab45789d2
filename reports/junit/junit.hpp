#pragma once
// A night as JUnit's XML, which continuous integration servers read.

#include "reports/analysis/history_night.hpp"

#include <string>

namespace alcove {

/// One testcase a gated series: failed if slower, worse or another image, skipped where there is
/// too little history. A series that is faster, better or not repeated passes and says so.
[[nodiscard]] std::string make_junit_xml(const Night& night);

} // namespace alcove
