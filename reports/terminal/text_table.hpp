#pragma once
// Text in columns, safe for a terminal.

#include <string>
#include <vector>

namespace alcove {

using TextLines = std::vector<std::vector<std::string>>;

/// Control characters would let a label from a file rewrite the terminal: they become "?".
[[nodiscard]] std::string clean_text(std::string text);

/// Every column as wide as its widest field, counted in UTF-8 characters.
[[nodiscard]] std::string align_columns(const TextLines& lines);

} // namespace alcove
