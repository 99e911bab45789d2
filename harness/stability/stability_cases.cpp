#include "harness/stability/stability_cases.hpp"

#include <iterator>
#include <utility>

namespace alcove {

std::vector<StabilityCase> list_stability_cases() {
    std::vector<StabilityCase> all;
    for (const auto& make :
         {make_precision_cases, make_plane_cases, make_size_cases, make_damage_cases,
          make_placement_cases, make_silhouette_cases, make_symmetry_cases, make_history_cases}) {
        std::vector<StabilityCase> family = make();
        std::move(family.begin(), family.end(), std::back_inserter(all));
    }
    return all;
}

} // namespace alcove
