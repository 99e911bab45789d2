#pragma once
// What the front end draws, as JSON inside the page: fetch() is blocked for pages opened from a
// file.

#include "reports/analysis/analysis.hpp"
#include "reports/html/pictures.hpp"

#include <string>

namespace alcove {

/// The text between <script type="application/json"> and its end, escaped. Its shape is declared in
/// reports/web/data.ts.
[[nodiscard]] std::string make_page_data(const RunAnalysis& analysis, const PictureFinder& finder);

} // namespace alcove
