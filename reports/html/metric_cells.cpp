#include "reports/html/metric_cells.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"

#include <fmt/core.h>

namespace alcove {

Best::Best(const RoundAnalysis& round, bool lower_is_better, Get get) : m_get(std::move(get)) {
    for (const CellAnalysis& cell : round.cells) {
        const std::optional<double> value = m_get(cell);
        if (is_compared(cell) && value &&
            (!m_best || (lower_is_better ? *value < *m_best : *value > *m_best))) {
            m_best = value;
        }
    }
}

const char* Best::mark(const CellAnalysis& cell) const {
    return is_compared(cell) && m_best && m_get(cell) == m_best ? "best" : "";
}

std::optional<double> get_ranked(const MetricAnalysis* metric) {
    if (metric == nullptr) {
        return std::nullopt;
    }
    return metric->is_below_floor ? *metric->floor : metric->shown();
}

std::string make_metric_cell(const MetricAnalysis* metric, const char* mark,
                             const std::string& extra) {
    if (metric == nullptr) {
        return "<td class=\"absent\">&ndash;</td>";
    }
    const std::string floor =
        metric->floor ? fmt::format("<small>floor {}</small>", format_rounded(*metric->floor)) : "";
    return fmt::format(
        "<td class=\"{}\" data-value=\"{}\"><b>{}</b>{}<small>{}..{} (n={})</small>{}</td>", mark,
        format_number(metric->shown()), escape_html(format_error(*metric)), extra,
        format_rounded(metric->minimum), format_rounded(metric->maximum), metric->frames, floor);
}

} // namespace alcove
