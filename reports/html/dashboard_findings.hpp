#pragma once
// The dashboard's upper part: what the last nights found, and the steps of earlier ones.

#include "reports/html/dashboard_data.hpp"

namespace alcove {

/// For every device and suite its last night with what left its fence, failures first, and the
/// charts of these series; then the newest steps of earlier nights.
[[nodiscard]] std::string make_findings_sections(const StoredHistory& history,
                                                 const std::vector<ShownSeries>& shown);

/// The place of a series' chart, filled by the script.
[[nodiscard]] std::string make_history_figure(const ShownSeries& shown);

} // namespace alcove
