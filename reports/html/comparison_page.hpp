#pragma once
// comparison.html: two runs side by side on one page without a script.

#include "reports/analysis/comparison.hpp"

#include <filesystem>
#include <string>

namespace alcove {

/// `folder` is where the page will stand; pictures of changed images are shown by paths relative
/// to it.
[[nodiscard]] std::string make_comparison_page(const Comparison& comparison,
                                               const std::filesystem::path& folder);

} // namespace alcove
