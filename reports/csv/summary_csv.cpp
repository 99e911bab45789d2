#include "reports/csv/summary_csv.hpp"

#include "core/base/file.hpp"
#include "reports/csv/csv_table.hpp"

#include <algorithm>

namespace alcove {
namespace {

/// What only this table has.
class SummaryTable : public CsvTable {
  public:
    void add_percentiles(const std::string& name, const std::optional<Percentiles>& percentiles) {
        add(name + "_p50_ms",
            percentiles ? std::optional<double>(percentiles->p50_ms) : std::nullopt);
        add(name + "_p95_ms",
            percentiles ? std::optional<double>(percentiles->p95_ms) : std::nullopt);
        add(name + "_p99_ms",
            percentiles ? std::optional<double>(percentiles->p99_ms) : std::nullopt);
        add_count(name + "_n", percentiles ? percentiles->n : 0);
    }

    void add_slow_frames(const std::optional<SlowFrames>& slow) {
        add("content_slowest_1_percent_mean_ms",
            slow ? std::optional(slow->slowest_mean) : std::nullopt);
        add("content_time_integral_1_percent_ms",
            slow ? std::optional(slow->time_integral) : std::nullopt);
    }

    void add_outliers(const std::optional<OutlierCount>& outliers) {
        add_count("outliers_mild", outliers ? outliers->mild : 0);
        add_count("outliers_severe", outliers ? outliers->severe : 0);
        add_count("outliers_n", outliers ? outliers->n : 0);
    }

    void add_machine(const Fitness& machine) {
        add("machine", std::string(to_text(machine.verdict)));
        std::string reasons;
        for (const std::string& reason : machine.reasons) {
            reasons += (reasons.empty() ? "" : "; ") + reason;
        }
        add("machine_reasons", reasons);
        add("machine_others_share", machine.others_share);
        add("machine_steal_share", machine.steal_share);
        add("machine_load", machine.load);
        add("machine_switches_per_s", machine.switches_per_s);
        add("machine_clock_mhz", machine.clock_mhz);
        add("machine_clock_spread", machine.clock_spread);
        add("machine_memory", machine.memory);
    }

    void add_error(const std::string& name, const MetricAnalysis* error) {
        const auto get = [&](double MetricAnalysis::*field) {
            return error != nullptr ? std::optional<double>(error->*field) : std::nullopt;
        };
        add(name, get(&MetricAnalysis::value));
        add(name + "_debiased", error != nullptr ? error->debiased : std::nullopt);
        add(name + "_floor", error != nullptr ? error->floor : std::nullopt);
        add(name + "_min", get(&MetricAnalysis::minimum));
        add(name + "_max", get(&MetricAnalysis::maximum));
        add_count(name + "_n", error != nullptr ? error->frames : 0);
        add_flag(name + "_below_floor", error != nullptr && error->is_below_floor);
    }

    void add_history(const std::string& name, const MetricAnalysis* number) {
        const auto get = [&](double MetricAnalysis::*field) {
            return number != nullptr ? std::optional<double>(number->*field) : std::nullopt;
        };
        add(name, get(&MetricAnalysis::value));
        add(name + "_min", get(&MetricAnalysis::minimum));
        add(name + "_max", get(&MetricAnalysis::maximum));
        add_count(name + "_n", number != nullptr ? number->frames : 0);
    }
};

std::string name_role(CellRole role) {
    return role == CellRole::method ? "method"
                                    : (role == CellRole::anchor ? "anchor" : "anchor_repeat");
}

/// Metrics of one kind of any round, so that all lines have the same columns.
std::vector<std::string> list_metrics(const RunAnalysis& analysis,
                                      std::vector<std::string> RoundAnalysis::*kind) {
    std::vector<std::string> names;
    for (const RoundAnalysis& round : analysis.rounds) {
        for (const std::string& metric : round.*kind) {
            if (std::find(names.begin(), names.end(), metric) == names.end()) {
                names.push_back(metric);
            }
        }
    }
    return names;
}

struct MetricNames {
    std::vector<std::string> image;
    std::vector<std::string> temporal;
    std::vector<std::string> history;
};

void add_line(SummaryTable& table, const RunAnalysis& analysis, const RoundAnalysis& round,
              const CellAnalysis& cell, const MetricNames& metrics) {
    table.begin_line();
    table.add_count("schema", kRunSchemaVersion);
    table.add("round", round.round.id);
    table.add("scene", round.round.scene);
    table.add("walkthrough", round.round.walkthrough);
    table.add("width", std::to_string(round.round.width));
    table.add("height", std::to_string(round.round.height));
    table.add("precision", round.round.precision);
    table.add_flag("warm", round.round.warm);
    table.add("device_class", analysis.context.device_class);
    table.add("anchor_version", analysis.context.anchor_version);
    table.add("cell", cell.cell.id);
    table.add("label", cell.cell.label);
    table.add("method", cell.cell.method);
    table.add("preset", cell.cell.preset);
    table.add("settings", cell.cell.settings);
    table.add("role", name_role(cell.cell.role));
    table.add("target", cell.cell.target);
    table.add("reference", round.round.reference.label);
    table.add_flag("has_passes", cell.cell.has_passes);
    table.add_estimate("ratio", cell.ratio);
    table.add_estimate("time_ms", cell.time_ms);
    table.add_estimate("converged_time_ms", cell.converged_time_ms);
    table.add_estimate("converged_share", cell.converged_share);
    table.add_estimate("input_ms", cell.input_ms);
    table.add_flag("input_cached", cell.has_cached_input);
    table.add_estimate("compose_ms", cell.compose_ms);
    table.add_estimate("base_ms", round.base_ms);
    table.add_estimate("total_ms", cell.total_ms);
    table.add_estimate("coverage", cell.coverage);
    table.add_percentiles("content", cell.content);
    table.add_slow_frames(cell.slow_frames);
    table.add_percentiles("noise", cell.noise);
    table.add_outliers(cell.outliers);
    table.add("lag1", cell.lag1);
    table.add_machine(round.machine);
    table.add("stop_reason", std::string(to_text(round.done.repeats.reason)));
    table.add("widest_half_width", round.done.repeats.widest);
    table.add("minimum_detectable_effect", round.minimum_detectable_effect);
    table.add("front_metric", round.front_metric);
    table.add_flag("on_front", cell.is_on_front);
    for (const std::string& metric : metrics.image) {
        table.add_error(metric + "_cold", cell.find(SampleState::cold, metric));
        table.add_error(metric + "_converged", cell.find(SampleState::converged, metric));
    }
    for (const std::string& metric : metrics.temporal) {
        table.add_error(metric + "_cold", cell.find_temporal(metric));
    }
    for (const std::string& number : metrics.history) {
        table.add_history(number + "_cold", cell.find_history(SampleState::cold, number));
        table.add_history(number + "_converged", cell.find_history(SampleState::converged, number));
    }
}

} // namespace

std::string make_summary_csv(const RunAnalysis& analysis) {
    const MetricNames metrics = {list_metrics(analysis, &RoundAnalysis::metrics),
                                 list_metrics(analysis, &RoundAnalysis::temporal_metrics),
                                 list_metrics(analysis, &RoundAnalysis::history_numbers)};
    SummaryTable table;
    for (const RoundAnalysis& round : analysis.rounds) {
        for (const CellAnalysis& cell : round.cells) {
            add_line(table, analysis, round, cell, metrics);
        }
    }
    return table.make_text();
}

void write_summary_csv(const RunFolder& run, const RunAnalysis& analysis) {
    write_file_atomically(run.path() / "summary.csv", make_summary_csv(analysis));
}

} // namespace alcove
