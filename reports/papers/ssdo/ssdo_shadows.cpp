#include "reports/papers/ssdo/ssdo_parts.hpp"

namespace alcove {

void judge_ssdo_shadows(Judge& judge) {
    judge.set_untestable({"SSDO-046", "SSDO-047", "SSDO-055", "SSDO-056", "SSDO-057", "SSDO-058",
                          "SSDO-059", "SSDO-060", "SSDO-061", "SSDO-062", "SSDO-063", "SSDO-064",
                          "SSDO-065", "SSDO-066", "SSDO-076", "SSDO-077"},
                         "not measured here: shadows of a single light in screen space, the "
                         "correction of shadow maps, and instant radiosity are planned methods");
}

} // namespace alcove
