#pragma once
// Table cells of metrics, and which of a column is the best.

#include "reports/analysis/analysis.hpp"

#include <functional>
#include <optional>
#include <string>

namespace alcove {

/// The best value of one column among the methods, by which its cells are marked.
class Best {
  public:
    using Get = std::function<std::optional<double>(const CellAnalysis&)>;
    Best(const RoundAnalysis& round, bool lower_is_better, Get get);
    /// A class name: "best" or empty.
    [[nodiscard]] const char* mark(const CellAnalysis& cell) const;

  private:
    Get m_get;
    std::optional<double> m_best;
};

/// What a metric is ranked by: what is under the floor is equally good. Nothing for no metric.
[[nodiscard]] std::optional<double> get_ranked(const MetricAnalysis* metric);

/// Value, then extremes with n frames, then the floor; a dash for no metric. `mark` is a class name
/// or empty, `extra` markup of a line below the value.
[[nodiscard]] std::string make_metric_cell(const MetricAnalysis* metric, const char* mark = "",
                                           const std::string& extra = {});

} // namespace alcove
