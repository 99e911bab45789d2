#pragma once
// A night as Markdown, fit for a message or a pull request.

#include "reports/analysis/history_night.hpp"

#include <string>

namespace alcove {

/// What failed first, then what else left its fence, then what the words mean.
[[nodiscard]] std::string make_night_markdown(const Night& night);

} // namespace alcove
