#pragma once
// The reproduction of: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical
// volumetric obscurance. 2015. Its experiments lie beside this file; what they say of each claim is
// judged here.

#include "reports/analysis/reproduction.hpp"
#include "reports/papers/evidence.hpp"

namespace alcove {

/// One verdict a claim of the paper, in the order of claims.csv; Table 1 and the data of figures 6,
/// 8, 9, 11 to 15; pictures of figures 6, 8, 9, 11 to 15, which lie in parts/<part>/ of the
/// reproduction's folder.
[[nodiscard]] Reproduction reproduce_statvo(const Evidence& evidence, const std::string& scale);

} // namespace alcove
