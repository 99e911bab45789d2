#include "reports/html/events.hpp"

#include "reports/html/escape.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/core.h>

namespace alcove {

std::vector<EventRecord> list_replayed_events(const RoundRecord& round) {
    std::vector<EventRecord> events;
    std::copy_if(round.events.begin(), round.events.end(), std::back_inserter(events),
                 [&round](const EventRecord& event) {
                     return std::any_of(round.segments.begin(), round.segments.end(),
                                        [&event](const SegmentRecord& segment) {
                                            return segment.begin <= event.frame &&
                                                   event.frame < segment.end;
                                        });
                 });
    return events;
}

std::string make_event_list(const RoundRecord& round) {
    std::string items;
    for (const EventRecord& event : list_replayed_events(round)) {
        items += fmt::format("<li><b>{}</b> {}</li>\n", event.frame, escape_html(event.label));
    }
    if (items.empty()) {
        return {};
    }
    return "<p class=\"note\">What happens, by frame:</p>\n<ul class=\"events\">\n" + items +
           "</ul>\n";
}

} // namespace alcove
