#include "reports/csv/stability_csv.hpp"

#include "core/base/text.hpp"
#include "reports/record/csv.hpp"

namespace alcove {
namespace {

void append_cell(std::string& text, const StabilityCaseRecord& described,
                 const StabilityMethodRecord& method, const StabilityCellRecord& cell) {
    const auto append = [&](std::vector<std::string> numbers) {
        std::vector<std::string> fields{std::to_string(kStabilitySchemaVersion),
                                        described.name,
                                        method.label,
                                        method.method,
                                        method.preset,
                                        std::string(to_text(cell.outcome)),
                                        cell.reason,
                                        described.axis,
                                        described.axis_unit};
        fields.insert(fields.end(), numbers.begin(), numbers.end());
        append_csv_line(text, fields);
    };
    if (cell.scores.empty()) {
        append({"", "", "", "", "", "", ""});
    }
    for (std::size_t i = 0; i < cell.scores.size(); ++i) {
        const StabilityScoreRecord& score = cell.scores[i];
        append({format_number(described.severities[i].value), format_number(score.score),
                format_number(score.bound), described.score_unit,
                format_number(compute_margin(score)), holds(score) ? "1" : "0", score.fault});
    }
}

} // namespace

std::string make_stability_csv(const StabilityRecord& record) {
    std::string text;
    append_csv_line(text, {"schema", "case", "label", "method", "preset", "outcome", "reason",
                           "axis", "axis_unit", "severity", "score", "bound", "score_unit",
                           "margin", "holds", "fault"});
    for (const StabilityCaseRecord& described : record.cases) {
        for (const StabilityMethodRecord& method : record.methods) {
            append_cell(text, described, method, find_cell(record, described.name, method.label));
        }
    }
    return text;
}

} // namespace alcove
