#pragma once
// The one place where text from a run becomes part of a page.

#include <string>
#include <string_view>

namespace alcove {

/// For element content and quoted attribute values: & < > " ' become entities, control characters
/// but tab and line breaks become spaces.
[[nodiscard]] std::string escape_html(std::string_view text);

/// For JSON inside <script type="application/json">: < > & and U+2028/9 become \u escapes, so that
/// no text can end the element or open a comment in it.
[[nodiscard]] std::string escape_inline_json(std::string_view json);

/// Percent-encodes a relative path for src and href; '/' stays.
[[nodiscard]] std::string escape_url_path(std::string_view path);

} // namespace alcove
