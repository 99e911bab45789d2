#pragma once
// The table that `alcove stability` ends with: a case a line, a method a column.

#include "reports/record/stability_record.hpp"

#include <string>

namespace alcove {

[[nodiscard]] std::string make_stability_table(const StabilityRecord& record);

} // namespace alcove
