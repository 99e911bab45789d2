#pragma once
// Image errors over parts of a frame (run --strata): means by metric, stratum and cell.

#include "reports/analysis/analysis.hpp"

namespace alcove {

/// A metric of a plan that is measured over a stratum: "rmse[dark]" is "rmse" and "dark".
struct StratumColumn {
    std::string metric;
    std::string stratum;
};
/// Nothing for a name that does not have that form.
[[nodiscard]] std::optional<StratumColumn> split_stratum_column(const std::string& name);

/// Counts pixels instead of measuring errors.
inline constexpr std::string_view kPixelCount = "pixels";

/// Fills RoundAnalysis::strata from the round's rows.
void analyze_strata(RoundAnalysis& round, const std::vector<MetricRow>& rows,
                    const PlanRecord& plan);

/// In the order of the plan, each once.
[[nodiscard]] std::vector<std::string> list_stratum_names(const RoundAnalysis& round);
/// The metrics that are measured over strata, without the count of pixels.
[[nodiscard]] std::vector<std::string> list_stratum_metrics(const RoundAnalysis& round);

/// Nothing where it was not measured.
[[nodiscard]] const StratumAnalysis* find_stratum(const RoundAnalysis& round,
                                                  const std::string& cell, SampleState state,
                                                  const std::string& metric,
                                                  const std::string& stratum);

} // namespace alcove
