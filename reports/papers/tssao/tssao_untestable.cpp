#include "reports/papers/tssao/tssao_parts.hpp"

namespace alcove {

void list_tssao_untestable(Judge& judge) {
    judge.set_untestable({"TSSAO-001", "TSSAO-002", "TSSAO-003", "TSSAO-004", "TSSAO-005",
                          "TSSAO-006", "TSSAO-007", "TSSAO-008", "TSSAO-009", "TSSAO-010",
                          "TSSAO-011", "TSSAO-012", "TSSAO-025", "TSSAO-026", "TSSAO-027",
                          "TSSAO-028", "TSSAO-029", "TSSAO-030", "TSSAO-031", "TSSAO-032",
                          "TSSAO-033", "TSSAO-034", "TSSAO-045", "TSSAO-046", "TSSAO-047",
                          "TSSAO-048", "TSSAO-049", "TSSAO-050", "TSSAO-081", "TSSAO-091"},
                         "needs a city with occlusion culling; there is none here yet");
    judge.set_untestable({"TSSAO-024"}, "no value is printed");
    judge.set_untestable({"TSSAO-070"}, "there is no metric of local contrast yet");
    judge.set_untestable({"TSSAO-071"},
                         "no run shows it: core_frame_reprojection_test compares the "
                         "motion channel with finite differences");
    judge.set_untestable({"TSSAO-080"}, "the cathedral does not reach that size yet");
    judge.set_untestable({"TSSAO-094", "TSSAO-134", "TSSAO-136"},
                         "needs a deforming or walking character; there is none here yet");
    judge.set_untestable({"TSSAO-096"}, "all samples come from one Halton table: there is no "
                                        "pseudo-random one to compare with");
    judge.set_untestable(
        {"TSSAO-097", "TSSAO-102", "TSSAO-104", "TSSAO-105", "TSSAO-106", "TSSAO-107"},
        "a definition, which no run shows: methods_tssao_test pins it with planted "
        "values");
    judge.set_untestable({"TSSAO-098"},
                         "needs a scene of more than a kilometre; there is none here "
                         "yet");
    judge.set_untestable({"TSSAO-100"}, "no run shows it: core_frame_reprojection_test pins both "
                                        "ways of reprojection");
    judge.set_untestable({"TSSAO-101", "TSSAO-103", "TSSAO-131", "TSSAO-140"},
                         "there is no metric of sharpness yet");
    judge.set_untestable({"TSSAO-109"}, "an example of the text, which Table 1 overrules");
    judge.set_untestable({"TSSAO-114"}, "there is no metric of the strip at the border yet");
    judge.set_untestable({"TSSAO-117"}, "the hardware of 2010");
    judge.set_untestable({"TSSAO-118"}, "sizes are smaller by the scale, in the same proportions");
    judge.set_untestable({"TSSAO-119"}, "a choice of formats: the history here is RGBA32F, the "
                                        "visibility R32F");
    judge.set_untestable({"TSSAO-122"}, "needs one surface at two distances in one comparison; no "
                                        "walkthrough here has that");
    judge.set_untestable({"TSSAO-127", "TSSAO-141"},
                         "about playing videos: nothing here is played or compressed");
    judge.set_untestable({"TSSAO-133"}, "there is no counter of filtered and rotated pixels; "
                                        "methods_tssao_test pins that converged ones are neither");
    judge.set_untestable({"TSSAO-143"}, "there is no metric of halos yet");
}

} // namespace alcove
