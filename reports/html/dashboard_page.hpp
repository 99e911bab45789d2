#pragma once
// The dashboard: what the last night found, and every series of the store over all nights. One file
// that opens from a disk without a network; its tables are complete without JavaScript.

#include "reports/record/store.hpp"

#include <string>

namespace alcove {

/// The page as it stands in dashboard/index.html beside the store: folders of runs that are given
/// relative to the store are linked.
[[nodiscard]] std::string make_dashboard_page(const StoredHistory& history);

} // namespace alcove
