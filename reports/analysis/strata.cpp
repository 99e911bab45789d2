#include "reports/analysis/strata.hpp"

#include "reports/analysis/metric_table.hpp"

#include <algorithm>

namespace alcove {
namespace {

void add_once(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        names.push_back(name);
    }
}

} // namespace

std::optional<StratumColumn> split_stratum_column(const std::string& name) {
    // The metric's own specification may hold any character, the stratum is what stands last.
    const std::size_t open = name.rfind('[');
    if (open == std::string::npos || open == 0 || name.back() != ']' || open + 2 >= name.size()) {
        return std::nullopt;
    }
    return StratumColumn{name.substr(0, open), name.substr(open + 1, name.size() - open - 2)};
}

void analyze_strata(RoundAnalysis& round, const std::vector<MetricRow>& rows,
                    const PlanRecord& plan) {
    for (const std::string& name : list_measured(rows, plan, kStratumKind)) {
        const std::optional<StratumColumn> column = split_stratum_column(name);
        if (!column) {
            continue;
        }
        const bool lower = is_lower_better(plan, name);
        for (const CellAnalysis& cell : round.cells) {
            std::vector<const MetricRow*> cold;
            std::vector<const MetricRow*> converged;
            for (const MetricRow& row : rows) {
                if (row.cell != cell.cell.id || row.metric != name) {
                    continue;
                }
                if (stands_in_cold(round.round, row)) {
                    cold.push_back(&row);
                }
                if (stands_in_converged(round.round, cell.cell, row)) {
                    converged.push_back(&row);
                }
            }
            const auto add = [&](SampleState state, const std::vector<const MetricRow*>& found) {
                if (!found.empty()) {
                    round.strata.push_back({column->metric, column->stratum, cell.cell.id, state,
                                            summarize_metric(name, found, lower), lower});
                }
            };
            add(SampleState::cold, cold);
            add(SampleState::converged, converged);
        }
    }
}

std::vector<std::string> list_stratum_names(const RoundAnalysis& round) {
    std::vector<std::string> names;
    for (const StratumAnalysis& part : round.strata) {
        add_once(names, part.stratum);
    }
    return names;
}

std::vector<std::string> list_stratum_metrics(const RoundAnalysis& round) {
    std::vector<std::string> names;
    for (const StratumAnalysis& part : round.strata) {
        if (part.metric != kPixelCount) {
            add_once(names, part.metric);
        }
    }
    return names;
}

const StratumAnalysis* find_stratum(const RoundAnalysis& round, const std::string& cell,
                                    SampleState state, const std::string& metric,
                                    const std::string& stratum) {
    const auto found =
        std::find_if(round.strata.begin(), round.strata.end(), [&](const StratumAnalysis& part) {
            return part.cell == cell && part.state == state && part.metric == metric &&
                   part.stratum == stratum;
        });
    return found == round.strata.end() ? nullptr : &*found;
}

} // namespace alcove
