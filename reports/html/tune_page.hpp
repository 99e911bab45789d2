#pragma once
// tune.html: what was fitted, how well it does where it was not, and how the search went.

#include "reports/record/tune_record.hpp"

#include <string>

namespace alcove {

/// The whole page; needs no script.
[[nodiscard]] std::string make_tune_page(const TuneRecord& record);

} // namespace alcove
