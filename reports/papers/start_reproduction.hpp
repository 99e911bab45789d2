#pragma once
// What every paper's reproduction begins as.

#include "reports/analysis/reproduction.hpp"
#include "reports/papers/evidence.hpp"
#include "reports/papers/judge.hpp"

#include <string>

namespace alcove {

/// Context, scale, a verdict each of `paper`'s claims and its errata; add tables and figures.
/// `paper` as in claims.csv ("TSSAO"), `citation`: author. title. year. Asserts as Judge::finish.
[[nodiscard]] Reproduction start_reproduction(const std::string& paper, const std::string& citation,
                                              const Evidence& evidence, const std::string& scale,
                                              const Judge& judge);

} // namespace alcove
