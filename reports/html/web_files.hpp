#pragma once
// The front end's files (reports/web) inside the binary.

#include <string_view>

namespace alcove {

/// "page.css", and the bundle: "report.js", "report.css" (empty without esbuild). Asserts that
/// there is such a file.
[[nodiscard]] std::string_view find_web_file(std::string_view name);

} // namespace alcove
