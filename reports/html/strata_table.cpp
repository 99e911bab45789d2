#include "reports/html/strata_table.hpp"

#include "reports/analysis/strata.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/metric_cells.hpp"
#include "reports/html/round_section.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace alcove {
namespace {

/// Of the first cell that was measured: pixels are the scene's, alike for all.
std::string describe_pixels(const RoundAnalysis& round, const std::string& stratum) {
    const double all = static_cast<double>(round.round.width) * round.round.height;
    for (const StratumAnalysis& part : round.strata) {
        if (part.metric == kPixelCount && part.stratum == stratum && part.value.frames > 0) {
            return fmt::format("{:.0f} px, {:.1f} % of a frame", part.value.value,
                               100.0 * part.value.value / all);
        }
    }
    return "not counted";
}

std::string make_head(const RunAnalysis& analysis, const RoundAnalysis& round,
                      const std::string& metric) {
    std::string head;
    for (const std::string& stratum : list_stratum_names(round)) {
        const MetricDescription* description =
            analysis.find_metric(fmt::format("{}[{}]", metric, stratum));
        head += fmt::format("<th data-sort title=\"{}\">{}<small>{}</small></th>",
                            description == nullptr ? "" : escape_html(description->definition),
                            escape_html(stratum), escape_html(describe_pixels(round, stratum)));
    }
    return head;
}

const MetricAnalysis* get_value(const StratumAnalysis* part) {
    return part == nullptr || part->value.frames == 0 ? nullptr : &part->value;
}

std::string make_row(const RoundAnalysis& round, const CellAnalysis& cell, std::size_t index,
                     SampleState state, const std::string& metric) {
    std::string row;
    bool has_values = false;
    for (const std::string& stratum : list_stratum_names(round)) {
        const StratumAnalysis* part = find_stratum(round, cell.cell.id, state, metric, stratum);
        const bool lower = part == nullptr || part->lower_is_better;
        const Best best(round, lower, [&](const CellAnalysis& other) {
            return get_ranked(
                get_value(find_stratum(round, other.cell.id, state, metric, stratum)));
        });
        has_values = has_values || part != nullptr;
        row += make_metric_cell(get_value(part), best.mark(cell));
    }
    return has_values ? fmt::format("<tr class=\"method\"><th scope=\"row\" class=\"name\">{}</th>"
                                    "<td class=\"text\">{}</td>{}</tr>\n",
                                    make_label(cell, index), to_text(state), row)
                      : std::string();
}

} // namespace

std::string make_strata_tables(const RunAnalysis& analysis, const RoundAnalysis& round) {
    std::string text;
    for (const std::string& metric : list_stratum_metrics(round)) {
        std::string rows;
        for (const SampleState state : {SampleState::cold, SampleState::converged}) {
            for (std::size_t i = 0; i < round.cells.size(); ++i) {
                if (round.cells[i].cell.role == CellRole::method) {
                    rows += make_row(round, round.cells[i], i, state, metric);
                }
            }
        }
        text += fmt::format("<h4>{}</h4>\n<div class=\"scroll\"><table class=\"wide\" "
                            "data-sortable><thead><tr><th class=\"name\">Method</th><th "
                            "class=\"text\">State</th>{}</tr></thead><tbody>\n{}</tbody></table>"
                            "</div>\n",
                            escape_html(metric), make_head(analysis, round, metric), rows);
    }
    return text.empty() ? text
                        : "<div class=\"strata\"><h3>By part of the frame</h3>\n<p "
                          "class=\"note\">Means over the frames in which the part has pixels; all "
                          "other pixels are ignored. Cold over bursts, converged over single "
                          "frames. Pixels are means over frames. A pixel may lie in several parts, "
                          "the background lies in none.</p>\n" +
                              text + "</div>\n";
}

} // namespace alcove
