#pragma once
// The reproduction of: Shanmugam, Arikan. Hardware accelerated ambient occlusion techniques on
// GPUs. 2007. Its experiments lie beside this file; what they say of each claim is judged here.

#include "reports/analysis/reproduction.hpp"
#include "reports/papers/evidence.hpp"

namespace alcove {

/// One verdict a claim of the paper, in the order of claims.csv; tables of figure 5 and of what
/// times and errors depend on; pictures of figures 1 d and 5 and of the closed room, which lie in
/// parts/<part>/ of the reproduction's folder.
[[nodiscard]] Reproduction reproduce_shanmugam_arikan(const Evidence& evidence,
                                                      const std::string& scale);

} // namespace alcove
