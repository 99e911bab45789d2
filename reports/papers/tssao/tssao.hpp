#pragma once
// The reproduction of: Mattausch, Scherzer, Wimmer. High-quality screen-space ambient occlusion
// using temporal coherence. 2010. Its experiments lie beside this file; what they say of each claim
// is judged here.

#include "reports/analysis/reproduction.hpp"
#include "reports/papers/evidence.hpp"

namespace alcove {

/// One verdict a claim of the paper, in the order of claims.csv; Table 1, Table 2 and the data of
/// figures 4, 6, 8, 9, 10 and 13; pictures of figures 6, 8, 9, 10 and 12, which lie in
/// parts/<part>/ of the reproduction's folder.
[[nodiscard]] Reproduction reproduce_tssao(const Evidence& evidence, const std::string& scale);

} // namespace alcove
