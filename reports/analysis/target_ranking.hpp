#pragma once
// Errors by target and by whose settings a cell has (DESIGN 3.8): who stands where under each
// target, and whose place changes when another falloff is asked for.

#include "reports/analysis/analysis.hpp"

namespace alcove {

struct RankedCell {
    std::string round;
    std::string cell;
    std::string label;
    std::string settings; ///< "common", "calibrated" or "native"
    std::string note;     ///< what of the target the method cannot do; empty if all of it
    Estimate error;       ///< over content, as everywhere
    /// 1 is best, of common and calibrated cells of the target; equal errors, and errors under the
    /// reference's floor, share a place. Nothing for native ones.
    std::optional<std::size_t> place;
};

struct RankedTarget {
    std::string target;
    std::vector<RankedCell> cells; ///< from the best on; native ones last, in the plan's order
};

/// The targets of one scene, walkthrough, choice of frames, size, precision and reference.
struct TargetRanking {
    std::string scene;
    std::string walkthrough;
    int width = 0;
    int height = 0;
    std::string precision;
    std::string reference;
    std::string metric;                    ///< the rounds' front metric
    SampleState state = SampleState::cold; ///< converged where singles were replayed
    std::vector<RankedTarget> targets;     ///< in the plan's order
    std::vector<std::string> moved;        ///< labels that do not have one place in all targets

    [[nodiscard]] const RankedCell* find(const RankedTarget& target,
                                         const std::string& label) const;
};

/// Only where there is something to tell: two targets or more, or settings other than common ones.
[[nodiscard]] std::vector<TargetRanking> rank_targets(const RunAnalysis& run);

} // namespace alcove
