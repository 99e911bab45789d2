#include "reports/csv/summary_csv.hpp"

#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "reports/record/csv.hpp"

#include <algorithm>

namespace alcove {
namespace {

/// Names and fields are made by the same calls, so that they cannot come apart.
class Table {
  public:
    void begin_line() { m_lines.emplace_back(); }
    void add(std::string column, std::string field) {
        if (m_lines.size() == 1) {
            m_columns.push_back(std::move(column));
        }
        m_lines.back().push_back(std::move(field));
    }
    void add(std::string column, std::optional<double> value) {
        add(std::move(column), value ? format_number(*value) : std::string());
    }
    void add_count(std::string column, std::size_t value) {
        add(std::move(column), std::to_string(value));
    }
    void add_flag(std::string column, bool value) {
        add(std::move(column), std::string(value ? "1" : "0"));
    }

    void add_estimate(const std::string& name, const std::optional<Estimate>& estimate) {
        const auto format = [&](double Estimate::*field) {
            return estimate ? format_number((*estimate).*field) : std::string();
        };
        const auto format_end = [&](double Interval::*end) {
            return estimate && estimate->interval ? format_number((*estimate->interval).*end)
                                                  : std::string();
        };
        add(name, format(&Estimate::value));
        add(name + "_lower95", format_end(&Interval::lower));
        add(name + "_upper95", format_end(&Interval::upper));
        add(name + "_min", format(&Estimate::minimum));
        add(name + "_max", format(&Estimate::maximum));
        add_count(name + "_n", estimate ? estimate->n : 0);
    }

    void add_percentiles(const std::string& name, const std::optional<Percentiles>& percentiles) {
        add(name + "_p50_ms",
            percentiles ? std::optional<double>(percentiles->p50_ms) : std::nullopt);
        add(name + "_p95_ms",
            percentiles ? std::optional<double>(percentiles->p95_ms) : std::nullopt);
        add_count(name + "_n", percentiles ? percentiles->n : 0);
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

    [[nodiscard]] std::string make_text() const {
        std::string text;
        append_csv_line(text, m_columns);
        for (const std::vector<std::string>& line : m_lines) {
            append_csv_line(text, line);
        }
        return text;
    }

  private:
    std::vector<std::string> m_columns;
    std::vector<std::vector<std::string>> m_lines;
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

void add_line(Table& table, const RunAnalysis& analysis, const RoundAnalysis& round,
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
    table.add_percentiles("noise", cell.noise);
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
    Table table;
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
