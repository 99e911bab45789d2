#pragma once
// Parameters on their way to people: the table of a unit's README.

#include "core/base/parameters.hpp"

namespace alcove {

/// The table as GitHub Markdown, as it stands between two marks in the unit's README.
[[nodiscard]] std::string make_markdown_table(const ParameterTable& table);

} // namespace alcove
