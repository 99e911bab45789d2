#include "reports/papers/artifacts/artifacts_parts.hpp"
#include "reports/papers/estimates.hpp"

namespace alcove {

std::vector<Artifact> list_artifacts() {
    const char* const kRipple = "band_profile";
    // Rounds of `depth`: three distances, each with 16, 24 and 32 bits.
    constexpr std::size_t kFarWith16Bits = 6;
    return {
        {"4.1",
         "depth-resolution speckle",
         {"depth", kFarWith16Bits, "no least cosine"},
         {"depth", kFarWith16Bits, "least cosine 0.15"},
         "false_occlusion",
         "least cosine 0.15"},
        {"4.2",
         "light bands of the range check",
         {"range_one", 0, "range of the ray"},
         {"range_many", 0, "range of the longest ray"},
         kRipple,
         "64 samples with random vectors"},
        {"4.3",
         "bands of one kernel",
         {"corner", 0, "rotation off"},
         {"corner", 0, "rotation on"},
         kRipple,
         "a random angle a pixel"},
        {"4.4",
         "clumped rotations",
         {"rotations", 0, "Gram-Schmidt"},
         {"rotations", 0, "fixed frame"},
         kRipple,
         "a fixed frame and a uniform angle"},
        {"4.5",
         "cones",
         {"corner", 0, "five cones"},
         {"corner", 0, "decoupled, two numbers"},
         kRipple,
         "directions and lengths by a random number each"},
        {"4.7",
         "noise",
         {"corner", 0, "no blur"},
         {"corner", 0, "blur"},
         "flat_noise",
         "cross-bilateral blur, 7x7"},
        {"4.8",
         "darkening by a distant foreground",
         {"foreground", 0, "no range check"},
         {"foreground", 0, "range check"},
         "false_occlusion",
         "a range of the longest ray"},
        {"4.9",
         "overdone occlusion",
         {"strength", 0, "gain 2.5"},
         {"strength", 0, "gain 1"},
         "false_occlusion:least=0.02",
         "a gain of 1"},
    };
}

Finding judge_artifact(const Evidence& evidence, const Artifact& artifact) {
    if (artifact.on.part == artifact.off.part) {
        return compare_metrics(evidence, artifact.off, artifact.on, artifact.metric,
                               SampleState::cold, artifact.name);
    }
    const Estimate on = evidence.estimate_metric(artifact.on, artifact.metric, SampleState::cold);
    const Estimate off = evidence.estimate_metric(artifact.off, artifact.metric, SampleState::cold);
    return {judge_order(on, off, 0.0),
            artifact.metric + " of " + artifact.on.label + " > of " + artifact.off.label, on,
            artifact.name};
}

} // namespace alcove
