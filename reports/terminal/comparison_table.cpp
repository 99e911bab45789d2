#include "reports/terminal/comparison_table.hpp"

#include "reports/analysis/comparison_wording.hpp"
#include "reports/terminal/text_table.hpp"

#include <fmt/core.h>

namespace alcove {
namespace {

std::string list_lines(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += "  " + clean_text(line) + "\n";
    }
    return text;
}

bool is_time(const ComparisonRow& row) {
    return row.what.starts_with("time");
}

} // namespace

std::string make_comparison_table(const Comparison& comparison) {
    TextLines lines = {
        {"verdict", "method", "scene", "what", "BASE", "NEW", "change", "margin", "evidence"}};
    std::size_t left_out = 0;
    for (const ComparisonRow& row : list_verdicts(comparison)) {
        if (row.verdict == Verdict::same && !is_time(row)) {
            ++left_out;
            continue;
        }
        lines.push_back({std::string(to_text(*row.verdict)), clean_text(row.cell->base.label),
                         clean_text(row.cell->round.scene), clean_text(row.what), row.base,
                         row.next, row.change, row.margin, clean_text(describe_evidence(row))});
    }
    std::string text = fmt::format("BASE {}\nNEW  {}\n{}", clean_text(comparison.base.name),
                                   clean_text(comparison.next.name), align_columns(lines));
    if (left_out > 0) {
        text += fmt::format("  {} metrics of {} methods stayed the same\n", left_out,
                            comparison.cells.size());
    }
    text += "images:\n" + list_lines(describe_images(comparison));
    const std::vector<std::string> settings = describe_settings(comparison);
    text += settings.empty() ? "" : "settings:\n" + list_lines(settings);
    const std::vector<std::string> unpaired = describe_unpaired(comparison);
    text += unpaired.empty() ? "" : "not compared:\n" + list_lines(unpaired);
    text += "runs:\n" + list_lines(comparison.notes) + list_lines(describe_method(comparison));
    return text + describe_discoveries(comparison) + "\n" + summarize_verdicts(comparison) + "\n";
}

} // namespace alcove
