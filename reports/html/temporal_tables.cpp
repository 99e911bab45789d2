#include "reports/html/temporal_tables.hpp"

#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/metric_cells.hpp"
#include "reports/html/round_section.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace alcove {
namespace {

std::string make_table(const std::string& head, const std::string& rows) {
    return "<div class=\"scroll\"><table class=\"wide\" data-sortable><thead><tr><th "
           "class=\"name\">Method</th>" +
           head + "</tr></thead><tbody>\n" + rows + "</tbody></table></div>\n";
}

/// `direction` is empty for what is neither good nor bad.
std::string make_metric_head(const MetricDescription& metric, std::string_view direction) {
    return fmt::format("<th data-sort title=\"{}: {}\">{}<small>{}{}{}</small></th>",
                       escape_html(metric.title), escape_html(metric.definition),
                       escape_html(metric.name), escape_html(metric.unit),
                       metric.unit.empty() || direction.empty() ? "" : ", ", direction);
}

std::string make_codes(const MetricAnalysis* metric) {
    return metric == nullptr ? std::string()
                             : fmt::format("<small class=\"codes\">&times;255: {}</small>",
                                           escape_html(format_codes(*metric)));
}

struct TemporalColumn {
    std::string name;
    Best best;
};

bool has_history(const CellAnalysis& cell) {
    return cell.cell.role == CellRole::method && cell.cell.warm_frames > 0;
}

std::string make_head_cell(const CellAnalysis& cell, std::size_t index) {
    return fmt::format("<tr class=\"method\"><th scope=\"row\" class=\"name\">{}</th>",
                       make_label(cell, index));
}

/// Cold and converged as bars against the longest time of the table.
std::string make_bars(const CellAnalysis& cell, std::size_t index, double longest_ms) {
    std::string text = "<td class=\"bars\">";
    for (const std::optional<Estimate>& time : {cell.time_ms, cell.converged_time_ms}) {
        const double share = time && longest_ms > 0.0 ? time->value / longest_ms : 0.0;
        text += fmt::format("<span class=\"bar\"><span class=\"{}\" "
                            "style=\"width:{:.1f}%\"></span></span>",
                            get_series_class(cell, index), 100.0 * std::clamp(share, 0.0, 1.0));
    }
    return text + "</td>";
}

} // namespace

std::string make_temporal_table(const RunAnalysis& analysis, const RoundAnalysis& round) {
    std::string head;
    std::vector<TemporalColumn> columns;
    for (const std::string& name : round.temporal_metrics) {
        const MetricDescription& metric = *analysis.find_metric(name); // the plan names its kind
        const bool lower = metric.lower_is_better;
        head += make_metric_head(metric, lower ? "lower is better" : "higher is better");
        columns.push_back({name, Best(round, lower, [name](const CellAnalysis& cell) {
                               return get_ranked(cell.find_temporal(name));
                           })});
    }
    if (columns.empty()) {
        return {};
    }
    std::string rows;
    for (std::size_t i = 0; i < round.cells.size(); ++i) {
        const CellAnalysis& cell = round.cells[i];
        if (cell.cell.role != CellRole::method) {
            continue;
        }
        rows += make_head_cell(cell, i);
        for (const TemporalColumn& column : columns) {
            const MetricAnalysis* metric = cell.find_temporal(column.name);
            rows += make_metric_cell(metric, column.best.mark(cell),
                                     column.name == kFlickerMetric ? make_codes(metric)
                                                                   : std::string());
        }
        rows += "</tr>\n";
    }
    return "<p class=\"note\">Means over the frames of the bursts that have a value, cold; some "
           "are "
           "told once a burst, on its last frame. Read the flicker ratio beside the flicker: it "
           "says "
           "how an error moves (0 sticks to surfaces, 1 is white in time), not how large it is. "
           "&times;255 is in codes of an 8-bit image. Definitions stand <a "
           "href=\"#definitions\">below</a>.</p>\n" +
           make_table(head, rows);
}

std::string make_history_table(const RunAnalysis& analysis, const RoundAnalysis& round) {
    std::string head = "<th class=\"text\">State</th>";
    for (const std::string& name : round.history_numbers) {
        head += make_metric_head(*analysis.find_metric(name), {});
    }
    std::string rows;
    for (std::size_t i = 0; i < round.cells.size(); ++i) {
        const CellAnalysis& cell = round.cells[i];
        for (const SampleState state : {SampleState::cold, SampleState::converged}) {
            const bool has_numbers = std::any_of(
                round.history_numbers.begin(), round.history_numbers.end(),
                [&](const std::string& name) { return cell.find_history(state, name) != nullptr; });
            if (!has_numbers) {
                continue;
            }
            rows +=
                make_head_cell(cell, i) + fmt::format("<td class=\"text\">{}</td>", to_text(state));
            for (const std::string& name : round.history_numbers) {
                rows += make_metric_cell(cell.find_history(state, name));
            }
            rows += "</tr>\n";
        }
    }
    if (rows.empty()) {
        return {};
    }
    return "<h4>What methods say of their history</h4>\n<p class=\"note\">Means over surface "
           "pixels and frames, neither good nor bad: they say why a time or an error is what it "
           "is. Cold over bursts, converged over single frames held still.</p>\n" +
           make_table(head, rows);
}

std::string make_convergence_table(const RunAnalysis& analysis, const RoundAnalysis& round) {
    double longest_ms = 0.0;
    for (const CellAnalysis& cell : round.cells) {
        if (has_history(cell)) {
            longest_ms = std::max({longest_ms, cell.time_ms ? cell.time_ms->value : 0.0,
                                   cell.converged_time_ms ? cell.converged_time_ms->value : 0.0});
        }
    }
    std::string rows;
    for (std::size_t i = 0; i < round.cells.size(); ++i) {
        const CellAnalysis& cell = round.cells[i];
        if (has_history(cell) && cell.converged_time_ms) {
            rows += make_head_cell(cell, i) + make_estimate_cell(cell.time_ms) +
                    make_estimate_cell(cell.converged_time_ms) +
                    make_estimate_cell(cell.converged_share) + make_bars(cell, i, longest_ms) +
                    make_estimate_cell(cell.input_ms, cell.has_cached_input ? "cached" : "") +
                    "</tr>\n";
        }
    }
    if (rows.empty()) {
        return {};
    }
    const std::string unit =
        fmt::format("<small>ms <em>{}</em></small>", escape_html(analysis.context.device_class));
    return "<h4>Cold against converged</h4>\n<p class=\"note\">Cold: the median over all replayed "
           "frames. Converged: the first and the last single frame, held until the history is "
           "full. "
           "The frames differ, so a ratio near 1 says little; far under 1, the method saves its "
           "samples where nothing moves. Input cost is paid in both.</p>\n" +
           make_table("<th data-sort>AO cold" + unit + "</th><th data-sort>AO converged" + unit +
                          "</th><th data-sort>Converged / cold<small>repeat by "
                          "repeat</small></th><th class=\"bars\">Cold, converged</th><th "
                          "data-sort>Input" +
                          unit + "</th>",
                      rows);
}

} // namespace alcove
