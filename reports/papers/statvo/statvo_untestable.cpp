#include "reports/papers/statvo/statvo_parts.hpp"

namespace alcove {

void list_statvo_untestable(Judge& judge) {
    judge.set_untestable({"STATVO-022", "STATVO-023", "STATVO-044"},
                         "the hardware of 2015, and frame rates on it");
    judge.set_untestable({"STATVO-024", "STATVO-068", "STATVO-069"},
                         "a definition, which no run shows");
    judge.set_untestable({"STATVO-025"}, "a definition: methods_statvo_test pins psi in image and "
                                         "oracle");
    judge.set_untestable({"STATVO-032"},
                         "no run shows layers: methods_statvo_test and the contract's planes pin "
                         "that an open surface stays 1 in every layering");
    judge.set_untestable({"STATVO-035"}, "no scene here has a slope beside a slab: "
                                         "methods_statvo_test sweeps it on depth images");
    judge.set_untestable({"STATVO-039"}, "there are no mipmaps, N-buffers or Y-maps to compare");
    judge.set_untestable({"STATVO-042", "STATVO-043"},
                         "no run shows it: methods_statvo_oracle_test holds both algorithms "
                         "against double precision");
    judge.set_untestable({"STATVO-058"}, "about the paper's own printed times");
    judge.set_untestable({"STATVO-061"},
                         "needs sample counts that are tuned to equal quality at each radius");
    judge.set_untestable({"STATVO-065"}, "there is no metric of signed error yet");
    judge.set_untestable({"STATVO-067"},
                         "needs a reference with a guard band and hidden surfaces in screen "
                         "space; ray tracing computes another quantity");
}

} // namespace alcove
