#pragma once
// stability.csv: one line a method, case and severity. Columns are documented in reports/README.md.

#include "reports/record/stability_record.hpp"

#include <string>

namespace alcove {

[[nodiscard]] std::string make_stability_csv(const StabilityRecord& record);

} // namespace alcove
