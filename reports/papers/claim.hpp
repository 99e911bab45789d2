#pragma once
// What the papers say, as data: claims.csv, one line a claim with the form of it that does not
// depend on the hardware, and errata.csv, where print or extraction is ambiguous and how it is
// read.

#include "reports/analysis/reproduction.hpp"

#include <string_view>
#include <vector>

namespace alcove {

/// All claims of a paper, in order. Asserts that the paper has claims.
[[nodiscard]] std::vector<Claim> load_claims(std::string_view paper);
[[nodiscard]] std::vector<Erratum> load_errata(std::string_view paper);

} // namespace alcove
