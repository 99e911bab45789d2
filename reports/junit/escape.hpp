#pragma once
// Text from a run or a store inside XML 1.0.

#include <string>
#include <string_view>

namespace alcove {

/// For element content and quoted attribute values: & < > " ' become entities; what XML 1.0 has no
/// form for (control characters, bytes that are no UTF-8, U+FFFE, U+FFFF, surrogates) becomes
/// U+FFFD, line ends and tabs become spaces.
[[nodiscard]] std::string escape_xml(std::string_view text);

} // namespace alcove
