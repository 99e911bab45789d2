#pragma once
// stability.html: the matrix of methods and hard cases, and a section a case, on one page without a
// script.

#include "reports/record/stability_record.hpp"

#include <string>

namespace alcove {

/// To stand in the record's folder: pictures are shown by their relative paths.
[[nodiscard]] std::string make_stability_page(const StabilityRecord& record);

} // namespace alcove
