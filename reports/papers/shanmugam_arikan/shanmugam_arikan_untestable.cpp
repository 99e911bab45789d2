#include "reports/papers/shanmugam_arikan/shanmugam_arikan_parts.hpp"

namespace alcove {

void list_shanmugam_arikan_untestable(Judge& judge) {
    judge.set_untestable({"SA07-001", "SA07-002", "SA07-003", "SA07-004", "SA07-005", "SA07-006",
                          "SA07-007", "SA07-008", "SA07-044", "SA07-045", "SA07-046", "SA07-048"},
                         "cards of 2004 to 2006, and frame rates on them; shares of a frame are "
                         "SA07-022 and SA07-038");
    judge.set_untestable({"SA07-009"},
                         "real time on a card of 2006; what polygons cost is SA07-032");
    judge.set_untestable({"SA07-011"},
                         "a scene's size; SA07-032 is measured at a million triangles");
    judge.set_untestable({"SA07-013", "SA07-026", "SA07-037"},
                         "a formula: methods_shanmugam_arikan_formulas_test pins it, its limits "
                         "and its table in double precision");
    judge.set_untestable({"SA07-015", "SA07-019"}, "what the others are measured against; 64 rays, "
                                                   "twice, as their noise must be known");
    judge.set_untestable({"SA07-020"}, "a frame rate of another device; its ratio is SA07-022");
    judge.set_untestable({"SA07-025", "SA07-027"},
                         "a diagram; the method's passes are those of its README, and their times "
                         "are in every run");
    judge.set_untestable({"SA07-029"}, "there are no disks to compare spheres with");
    judge.set_untestable(
        {"SA07-042", "SA07-043"},
        "a definition, which no run shows; figure 5's table has both values within "
        "a sphere, 1 as printed and 0 by default");
}

} // namespace alcove
