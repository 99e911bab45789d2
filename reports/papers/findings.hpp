#pragma once
// Findings that judgements of several papers are made of.

#include "reports/papers/evidence.hpp"
#include "reports/papers/judge.hpp"

#include <string>
#include <vector>

namespace alcove {

/// Is a's metric below b's, frame by frame? Of cells of one part, with equally many frames.
[[nodiscard]] Finding compare_metrics(const Evidence& evidence, const CellAddress& a,
                                      const CellAddress& b, const std::string& metric,
                                      SampleState state, const std::string& on);

/// The weakest of several findings, at least one, speaks for all.
[[nodiscard]] Finding combine_findings(const std::vector<Finding>& findings,
                                       const std::string& tested);

/// "8 views of cathedral at 320x180": on what a round's numbers were found.
[[nodiscard]] std::string describe_round(const Evidence& evidence, const std::string& part,
                                         std::size_t round = 0);

/// A picture that a cell's run kept of a frame, by its path from the reproduction's folder.
[[nodiscard]] FigurePicture make_cell_picture(const Evidence& evidence, const CellAddress& cell,
                                              int frame, const std::string& picture,
                                              const std::string& caption);

} // namespace alcove
