#pragma once
// Which cell of a run to take for a quality: the fastest that surely has it, or that the data
// cannot decide.

#include "reports/analysis/tradeoff.hpp"

namespace alcove {

/// "RMSE<0.05", "ssim>0.95": a metric's name in any case and a bound.
struct QualityBound {
    std::string metric;
    bool is_below = true;
    double bound = 0.0;
};
/// Throws InputError naming --quality and, for an unknown metric, the nearest of the run's; also if
/// the comparison is against the metric's direction.
[[nodiscard]] QualityBound parse_quality(std::string_view text, const PlanRecord& plan);

struct Recommendation {
    std::string scene;
    std::string target;
    int width = 0;
    int height = 0;
    /// Cells that may be the fastest with that quality, from fast to slow; none: nothing has it.
    /// One: decided. Several: their times are not told apart.
    std::vector<TradeoffPoint> cells;
    /// Faster cells of which the interval holds the bound: with them the data cannot decide.
    std::vector<TradeoffPoint> uncertain;
    /// The most accurate cell, for when nothing has the quality.
    TradeoffPoint most_accurate;
};

/// One for every scene and target of the run.
[[nodiscard]] std::vector<Recommendation> recommend(const RunAnalysis& run,
                                                    const QualityBound& quality);

/// For people, in a line or two.
[[nodiscard]] std::string describe_recommendation(const Recommendation& recommendation,
                                                  const QualityBound& quality);

} // namespace alcove
