#pragma once
// The catalogue by subject; for artifacts.cpp alone.

#include "reports/papers/findings.hpp"

#include <string>
#include <utility>
#include <vector>

namespace alcove {

/// One artefact: where a scalar is larger with it than without.
struct Artifact {
    std::string number; ///< in the catalogue: "4.1"
    std::string name;
    CellAddress on;
    CellAddress off;
    std::string metric;
    std::string removed_by;
};

/// In the catalogue's order, without those that are no matter of a metric.
[[nodiscard]] std::vector<Artifact> list_artifacts();
/// Is the scalar off below the scalar on? Frame by frame where both are of one part, else by their
/// intervals.
[[nodiscard]] Finding judge_artifact(const Evidence& evidence, const Artifact& artifact);

/// What follows from the published numbers that cells ran with: indices, angles, shares.
void judge_artifact_formulas(const Evidence& evidence, Judge& judge);
/// Chi square, 15 degrees of freedom, of the angles to which Gram-Schmidt turns 4096 evenly spaced
/// vectors about a normal that leans `tilt` radians from the view, in 16 bins.
[[nodiscard]] double measure_angle_chi_square(double tilt);
[[nodiscard]] PaperTable make_angles_table();
[[nodiscard]] PaperTable make_indices_table(const Evidence& evidence);

} // namespace alcove
