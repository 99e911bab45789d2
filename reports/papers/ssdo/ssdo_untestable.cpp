#include "reports/papers/ssdo/ssdo_parts.hpp"

namespace alcove {

void list_ssdo_untestable(Judge& judge) {
    judge.set_untestable({"SSDO-041"}, "a frame rate of another device at a number of samples that "
                                       "is not printed; ratios are those of table 1");
    judge.set_untestable({"SSDO-069", "SSDO-070"},
                         "a definition, which no run shows: methods_ssdo_test holds the sum "
                         "against what an unoccluded plane gets");
    judge.set_untestable({"SSDO-078"}, "the hardware of 2009");
    judge.set_untestable({"SSDO-081"},
                         "what binds a card of 2009; passes here run on a processor, whose "
                         "texture fetches are computation");
    judge.set_untestable({"SSDO-084"},
                         "a choice of the radius that is made by hand; scenes here name theirs");
}

} // namespace alcove
