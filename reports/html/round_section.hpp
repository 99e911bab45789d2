#pragma once
// Markup of one finished round.

#include "reports/analysis/analysis.hpp"
#include "reports/html/pictures.hpp"

#include <string>

namespace alcove {

/// Verdict, summary, places for the charts and the viewer, pictures and the detailed tables.
[[nodiscard]] std::string make_round_section(const RunAnalysis& analysis,
                                             const RoundAnalysis& round,
                                             const PictureFinder& finder);

/// The summary table alone: one row a cell, the best of each column and the front marked.
[[nodiscard]] std::string make_summary_table(const RunAnalysis& analysis,
                                             const RoundAnalysis& round);

/// Folding blocks below the pictures: errors with floors, passes with coverage, content and noise,
/// parameters.
[[nodiscard]] std::string make_detail_tables(const RunAnalysis& analysis,
                                             const RoundAnalysis& round);

/// A table cell with an estimate: value above, interval or extremes and n below. `mark` is a class
/// name or empty.
[[nodiscard]] std::string make_estimate_cell(const std::optional<Estimate>& estimate,
                                             const char* mark = "");

/// Colours of methods in page.css; a round has the anchor twice and up to 8 methods.
inline constexpr std::size_t kSeriesColors = 10;

/// Class that gives an element a cell's colour: "series-3", or "series-anchor" for both anchors.
[[nodiscard]] std::string get_series_class(const CellAnalysis& cell, std::size_t index);

/// Markup of a label that can break between its parts.
[[nodiscard]] std::string make_breakable(std::string_view label);

/// A method's name with its colour; `index` is its position in the round, `badge` markup that
/// stands behind the name.
[[nodiscard]] std::string make_label(const CellAnalysis& cell, std::size_t index,
                                     std::string_view badge = {});

} // namespace alcove
