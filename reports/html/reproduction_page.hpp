#pragma once
// The page of a reproduction: verdicts, fails first; tables and figures, published beside measured.
// One file; pictures beside it by relative path; no script.

#include "reports/analysis/reproduction.hpp"

#include <string>

namespace alcove {

[[nodiscard]] std::string make_reproduction_page(const Reproduction& reproduction);

} // namespace alcove
