#pragma once
// What the dashboard's charts draw: every series replayed night by night.

#include "reports/analysis/history_night.hpp"

#include <map>
#include <string>

namespace alcove {

/// A series as the dashboard shows it.
struct ShownSeries {
    const StoredSeries* series = nullptr; ///< of the history, which must outlive it
    std::string device_class;
    std::vector<HistoryNight> nights; ///< one a point; empty for images
};

/// All series, in the store's order.
[[nodiscard]] std::vector<ShownSeries> replay_series(const StoredHistory& history);

/// "x anchor, software", "rmse"
[[nodiscard]] std::string describe_unit(const ShownSeries& shown);

/// JSON, safe inside a script element. Series of milliseconds stand beside the time of their cell,
/// images as marks in all charts of theirs.
[[nodiscard]] std::string make_dashboard_data(const StoredHistory& history,
                                              const std::vector<ShownSeries>& shown);

} // namespace alcove
