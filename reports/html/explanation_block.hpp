#pragma once
// Why a round's images are wrong: errors in steps with their pictures, and what a curve would mend.

#include "reports/analysis/analysis.hpp"
#include "reports/html/pictures.hpp"

#include <string>

namespace alcove {

/// Empty where the round was not explained.
[[nodiscard]] std::string make_explanation_block(const RoundAnalysis& round,
                                                 const PictureFinder& finder);

} // namespace alcove
