#include "reports/terminal/stability_table.hpp"

#include "reports/analysis/stability_wording.hpp"
#include "reports/terminal/text_table.hpp"

namespace alcove {
namespace {

std::string list_faults(const StabilityRecord& record) {
    std::string text;
    for (const StabilityCellRecord& cell : record.cells) {
        for (const StabilityScoreRecord& score : cell.scores) {
            if (!score.fault.empty()) {
                text += "  " + clean_text(cell.case_name + ", " + cell.label + ": " + score.fault) +
                        "\n";
                break;
            }
        }
    }
    return text.empty() ? text : "faults:\n" + text;
}

} // namespace

std::string make_stability_table(const StabilityRecord& record) {
    TextLines lines{{"case"}};
    std::string methods;
    for (std::size_t i = 0; i < record.methods.size(); ++i) {
        const std::string number = "[" + std::to_string(i + 1) + "]";
        lines.front().push_back(number);
        methods += "  " + number + " " + clean_text(record.methods[i].label) + "\n";
    }
    for (const StabilityCaseRecord& described : record.cases) {
        std::vector<std::string> line{clean_text(described.name)};
        for (const StabilityMethodRecord& method : record.methods) {
            line.push_back(clean_text(
                describe_outcome(described, find_cell(record, described.name, method.label))));
        }
        lines.push_back(std::move(line));
    }
    return align_columns(lines) + methods + list_faults(record) +
           "numbers: worst (bound - score) / bound, 0 or more holds; x: a fault, or a bound of 0 "
           "that is not met\n" +
           summarize_stability(record) + "\n";
}

} // namespace alcove
