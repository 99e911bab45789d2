#pragma once
// The reproduction of the blog "Know your SSAO artifacts", 2013: each artefact provoked and removed
// in a scene of its own. The experiments lie beside this file; what they say of each claim is
// judged here.

#include "reports/analysis/reproduction.hpp"
#include "reports/papers/evidence.hpp"

namespace alcove {

/// One verdict a claim of BLOG in the order of claims.csv; the catalogue as a table with a scalar
/// on and off; what follows from formulas alone; a pair of pictures an artefact.
[[nodiscard]] Reproduction reproduce_artifacts(const Evidence& evidence, const std::string& scale);

} // namespace alcove
