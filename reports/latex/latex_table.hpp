#pragma once
// Tables for papers: LaTeX with the package booktabs.

#include "reports/analysis/reproduction.hpp"

#include <string>
#include <string_view>

namespace alcove {

/// Characters that LaTeX reads become what prints them: & % $ # _ { } ~ ^ \ < > |; control
/// characters become spaces.
[[nodiscard]] std::string escape_latex(std::string_view text);

/// A table environment with \toprule, \midrule and \bottomrule, caption and label `tab:<id>`; the
/// first column left, the others right. Needs \usepackage{booktabs}.
[[nodiscard]] std::string make_latex_table(const PaperTable& table);

} // namespace alcove
