#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/metric_cells.hpp"
#include "reports/html/round_section.hpp"

#include "core/base/text.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace alcove {
namespace {

std::optional<double> get_value(const std::optional<Estimate>& estimate) {
    return estimate ? std::optional<double>(estimate->value) : std::nullopt;
}

/// The two error columns of a metric with their best values.
struct MetricColumns {
    std::string name;
    Best cold;
    Best converged;
};

std::vector<MetricColumns> make_metric_columns(const RunAnalysis& analysis,
                                               const RoundAnalysis& round) {
    std::vector<MetricColumns> columns;
    for (const std::string& name : round.metrics) {
        const MetricDescription* metric = analysis.find_metric(name);
        const bool lower = metric == nullptr || metric->lower_is_better;
        const auto getter = [name](SampleState state) {
            return [name, state](const CellAnalysis& cell) {
                return get_ranked(cell.find(state, name));
            };
        };
        columns.push_back({name, Best(round, lower, getter(SampleState::cold)),
                           Best(round, lower, getter(SampleState::converged))});
    }
    std::stable_partition(columns.begin(), columns.end(), [&](const MetricColumns& column) {
        return column.name == round.front_metric;
    });
    return columns;
}

std::string make_metric_head(const RunAnalysis& analysis, const std::string& metric) {
    const MetricDescription* description = analysis.find_metric(metric);
    const bool lower = description == nullptr || description->lower_is_better;
    return fmt::format("<th colspan=\"2\" class=\"group\">{}<small>{} is better</small></th>",
                       escape_html(metric), lower ? "lower" : "higher");
}

/// The metric of the front stands beside the time, the others behind the milliseconds.
std::string make_head(const RunAnalysis& analysis, const std::vector<MetricColumns>& metrics) {
    const std::string device = escape_html(analysis.context.device_class);
    const auto time = [&](const char* title, const char* help) {
        return fmt::format(
            "<th rowspan=\"2\" data-sort title=\"{}\">{}<small>ms <em>{}</em></small></th>", help,
            title, device);
    };
    const std::string times =
        time("AO", "Its own passes as one piece, cold") +
        time("AO converged", "The same after warming up; equal where there is no history") +
        time("Input", "What it asks of the G-buffer beyond the base") +
        time("Frame", "Base G-buffer, input, AO and composition");
    std::string text =
        "<thead><tr><th rowspan=\"2\" class=\"name\">Method</th><th rowspan=\"2\" data-sort "
        "title=\"Envelope over the anchor's on the same frames\">Time<small>&times; "
        "anchor</small></th>";
    std::string second;
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        text += make_metric_head(analysis, metrics[i].name) + (i == 0 ? times : "");
        second += "<th data-sort class=\"first\">cold<small>n frames</small></th>"
                  "<th data-sort>converged<small>n frames</small></th>";
    }
    text += metrics.empty() ? times : "";
    return text + "</tr><tr>" + second + "</tr></thead>\n";
}

/// The columns of a row with the best value of each.
struct SummaryColumns {
    Best ratio;
    Best time;
    Best converged;
    Best total;
    std::vector<MetricColumns> metrics;
};

std::string make_ratio_cell(const CellAnalysis& cell, const SummaryColumns& columns) {
    if (cell.cell.role == CellRole::anchor) {
        return "<td data-value=\"1\"><b>1</b><small>the unit</small></td>";
    }
    return make_estimate_cell(cell.ratio, columns.ratio.mark(cell));
}

std::string make_time_cells(const CellAnalysis& cell, const SummaryColumns& columns) {
    const std::string rest =
        make_estimate_cell(cell.input_ms, cell.has_cached_input ? "cached" : "") +
        make_estimate_cell(cell.total_ms, columns.total.mark(cell));
    if (!cell.cell.has_passes) {
        const std::string zero = "<td data-value=\"0\"><b>0</b><small>no passes</small></td>";
        return zero + zero + rest;
    }
    return make_estimate_cell(cell.time_ms, columns.time.mark(cell)) +
           make_estimate_cell(cell.converged_time_ms, columns.converged.mark(cell)) + rest;
}

constexpr std::string_view kFrontBadge = " <span class=\"front\" title=\"No other method is both "
                                         "faster and more accurate\">front</span>";

std::string make_row(const CellAnalysis& cell, std::size_t index, const SummaryColumns& columns) {
    std::string text =
        fmt::format("<tr class=\"{}\"><th scope=\"row\" class=\"name\">{}</th>",
                    cell.cell.role == CellRole::method ? "method" : "anchor",
                    make_label(cell, index, cell.is_on_front ? kFrontBadge : std::string_view()));
    text += make_ratio_cell(cell, columns);
    const std::string times = make_time_cells(cell, columns);
    for (std::size_t i = 0; i < columns.metrics.size(); ++i) {
        const MetricColumns& metric = columns.metrics[i];
        text += make_metric_cell(cell.find(SampleState::cold, metric.name), metric.cold.mark(cell));
        text += make_metric_cell(cell.find(SampleState::converged, metric.name),
                                 metric.converged.mark(cell));
        text += i == 0 ? times : "";
    }
    text += columns.metrics.empty() ? times : "";
    return text + "</tr>\n";
}

} // namespace

std::string make_estimate_cell(const std::optional<Estimate>& estimate, const char* mark) {
    if (!estimate) {
        return "<td class=\"absent\">&ndash;</td>";
    }
    const EstimateText text = format_estimate(*estimate);
    return fmt::format("<td class=\"{}\" data-value=\"{}\"><b>{}</b><small>{}</small></td>", mark,
                       format_number(estimate->value), text.value, text.spread);
}

std::string get_series_class(const CellAnalysis& cell, std::size_t index) {
    return "series-" + (cell.cell.role == CellRole::method ? std::to_string(index % kSeriesColors)
                                                           : std::string("anchor"));
}

std::string make_breakable(std::string_view label) {
    std::string text;
    for (const char c : label) {
        text += escape_html(std::string_view(&c, 1));
        if (c == ':' || c == ',' || c == '@') {
            text += "<wbr>";
        }
    }
    return text;
}

std::string make_label(const CellAnalysis& cell, std::size_t index, std::string_view badge) {
    return fmt::format(
        "<span class=\"cell-label\"><span class=\"swatch {}\"></span><span>{}{}</span></span>",
        get_series_class(cell, index), make_breakable(cell.cell.label), badge);
}

std::string make_summary_table(const RunAnalysis& analysis, const RoundAnalysis& round) {
    const SummaryColumns columns = {
        Best(round, true, [](const CellAnalysis& c) { return get_value(c.ratio); }),
        Best(round, true, [](const CellAnalysis& c) { return get_value(c.time_ms); }),
        Best(round, true, [](const CellAnalysis& c) { return get_value(c.converged_time_ms); }),
        Best(round, true,
             [](const CellAnalysis& c) {
                 return c.cell.has_passes ? get_value(c.total_ms) : std::nullopt;
             }),
        make_metric_columns(analysis, round)};
    std::string methods;
    std::string anchors;
    for (std::size_t i = 0; i < round.cells.size(); ++i) {
        const CellAnalysis& cell = round.cells[i];
        (cell.cell.role == CellRole::method ? methods : anchors) += make_row(cell, i, columns);
    }
    return "<div class=\"scroll\"><table class=\"summary\" data-sortable>\n" +
           make_head(analysis, columns.metrics) + "<tbody>\n" + methods + anchors +
           "</tbody></table></div>\n";
}

} // namespace alcove
