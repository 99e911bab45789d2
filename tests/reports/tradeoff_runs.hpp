#pragma once
// Runs for trade-offs, made by hand: every time and error stands in the test.

#include "reports/analysis/tradeoff.hpp"

#include <string>
#include <vector>

namespace alcove {

using Labels = std::vector<std::string>;
[[nodiscard]] Labels list_labels(const std::vector<TradeoffPoint>& points);

/// A value with an interval of this half width.
[[nodiscard]] Estimate known(double value, double half_width);

/// A cell of the method that its label begins with; the error is a cold one.
[[nodiscard]] CellAnalysis make_cell(const std::string& label, Estimate time,
                                     const std::string& metric, Estimate error);

/// One burst of four frames, 10 up to 14.
[[nodiscard]] RoundAnalysis make_round(const std::string& id, std::vector<CellAnalysis> cells);

/// With the metrics rmse and ssim in its plan.
[[nodiscard]] RunAnalysis make_run(std::vector<RoundAnalysis> rounds);

/// Times and rmse: a:n=1 1 and 0.08, a:n=4 4 and 0.02, b 5 and 0.04, slow 8 and 0.01. All intervals
/// reach `width` to either side, in parts of the value.
[[nodiscard]] RunAnalysis make_simple_run(double width);

} // namespace alcove
