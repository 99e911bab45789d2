#pragma once
// The list of hard cases. A family is one file in cases/.

#include "harness/stability/stability_case.hpp"

#include <vector>

namespace alcove {

/// All of them, in the order of reports.
[[nodiscard]] std::vector<StabilityCase> list_stability_cases();

// One function a file.
[[nodiscard]] std::vector<StabilityCase> make_precision_cases();
[[nodiscard]] std::vector<StabilityCase> make_plane_cases();
[[nodiscard]] std::vector<StabilityCase> make_size_cases();
[[nodiscard]] std::vector<StabilityCase> make_damage_cases();
[[nodiscard]] std::vector<StabilityCase> make_placement_cases();
[[nodiscard]] std::vector<StabilityCase> make_silhouette_cases();
[[nodiscard]] std::vector<StabilityCase> make_symmetry_cases();
[[nodiscard]] std::vector<StabilityCase> make_history_cases();

} // namespace alcove
