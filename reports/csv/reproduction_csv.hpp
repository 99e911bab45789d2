#pragma once
// A reproduction's verdicts and tables as CSV.

#include "reports/analysis/reproduction.hpp"

#include <string>

namespace alcove {

/// id, location, published value, tested form, outcome, measured value with its interval, n, why.
[[nodiscard]] std::string make_verdicts_csv(const Reproduction& reproduction);
[[nodiscard]] std::string make_table_csv(const PaperTable& table);

} // namespace alcove
