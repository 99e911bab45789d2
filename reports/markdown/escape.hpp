#pragma once
// The one place where text from a run becomes part of a Markdown page.

#include <string>
#include <string_view>

namespace alcove {

/// For running text and table fields of GitHub's Markdown: what could begin markup, a mention, an
/// HTML element or another table field is escaped; control characters become spaces.
[[nodiscard]] std::string escape_markdown(std::string_view text);

} // namespace alcove
