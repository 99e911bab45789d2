#include "reports/terminal/time_table.hpp"

#include "reports/analysis/wording.hpp"
#include "reports/terminal/text_table.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace alcove {
namespace {

struct TimeColumn {
    std::string_view metric;
    const char* head;
    const char* meaning;
};

/// What a reader decides by; all metrics over time stand on the page and in summary.csv.
constexpr TimeColumn kColumns[] = {
    {kFlickerMetric, "TF x255", "TF: change of the error from frame to frame"},
    {"flicker_ratio", "rho", "rho: 0 sticks to surfaces, 1 is white in time"},
    {"trail_energy", "trail energy", "trail energy: error where truth has brightened"},
    {"recovery_frames", "recovery", "recovery: frames until what came into view is steady"},
    {"missed_invalidation", "missed inv.", "missed inv.: stale history kept"},
    {"false_invalidation", "false inv.", "false inv.: good history dropped"},
    {"history_samples", "samples/px", "samples/px: taken in a frame"},
};

const MetricAnalysis* find_value(const CellAnalysis& cell, const TimeColumn& column) {
    const std::string name(column.metric);
    const MetricAnalysis* value = cell.find_temporal(name);
    return value != nullptr ? value : cell.find_history(SampleState::cold, name);
}

std::string format_value(const CellAnalysis& cell, const TimeColumn& column) {
    const MetricAnalysis* value = find_value(cell, column);
    if (value == nullptr) {
        return "-";
    }
    return fmt::format(
        "{} (n={})", column.metric == kFlickerMetric ? format_codes(*value) : format_error(*value),
        value->frames);
}

} // namespace

std::string make_time_table(const RoundAnalysis& round) {
    TextLines lines = {{"", "over time, cold"}};
    std::string meaning;
    std::vector<const TimeColumn*> columns;
    for (const TimeColumn& column : kColumns) {
        if (std::any_of(round.cells.begin(), round.cells.end(), [&](const CellAnalysis& cell) {
                return find_value(cell, column) != nullptr;
            })) {
            columns.push_back(&column);
            lines[0].emplace_back(column.head);
            meaning += (meaning.empty() ? "" : "; ") + std::string(column.meaning);
        }
    }
    if (columns.empty()) {
        return {};
    }
    for (const CellAnalysis& cell : round.cells) {
        if (cell.cell.role != CellRole::method) {
            continue;
        }
        lines.push_back({"", clean_text(cell.cell.label)});
        for (const TimeColumn* column : columns) {
            lines.back().push_back(format_value(cell, *column));
        }
    }
    return align_columns(lines) + "  " + meaning + ".\n";
}

} // namespace alcove
