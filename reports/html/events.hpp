#pragma once
// What happens in a walkthrough, where it can be seen.

#include "reports/record/record.hpp"

#include <string>
#include <vector>

namespace alcove {

/// The round's events on frames that were replayed.
[[nodiscard]] std::vector<EventRecord> list_replayed_events(const RoundRecord& round);

/// Markup of their list; empty if there are none.
[[nodiscard]] std::string make_event_list(const RoundRecord& round);

} // namespace alcove
