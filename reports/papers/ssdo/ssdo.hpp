#pragma once
// The reproduction of: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image
// space. 2009. Its experiments lie beside this file; what they say of each claim is judged here.

#include "reports/analysis/reproduction.hpp"
#include "reports/papers/evidence.hpp"

namespace alcove {

/// One verdict a claim of the paper, in the order of claims.csv; table 1 with the published cells
/// beside the measured ones, and tables of figures 4, 5, 7, 9, 13 and 14; pictures of figures 3 to
/// 14, which lie in parts/<part>/ of the reproduction's folder.
[[nodiscard]] Reproduction reproduce_ssdo(const Evidence& evidence, const std::string& scale);

} // namespace alcove
