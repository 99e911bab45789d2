#pragma once
// What tuning found, for a terminal.

#include "reports/record/tune_record.hpp"

#include <string>

namespace alcove {

[[nodiscard]] std::string make_tune_table(const TuneRecord& record);

} // namespace alcove
