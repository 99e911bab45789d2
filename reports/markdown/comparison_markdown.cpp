#include "reports/markdown/comparison_markdown.hpp"

#include "reports/analysis/comparison_wording.hpp"
#include "reports/markdown/escape.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace alcove {
namespace {

std::string make_row(const ComparisonRow& row) {
    const std::string verdict = row.verdict ? std::string(to_text(*row.verdict)) : "";
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                       row.verdict == Verdict::worse ? "**" + verdict + "**" : verdict,
                       escape_markdown(row.cell->base.label),
                       escape_markdown(row.cell->round.scene), escape_markdown(row.what),
                       escape_markdown(row.base), escape_markdown(row.next),
                       escape_markdown(row.change), escape_markdown(row.margin),
                       escape_markdown(describe_evidence(row)));
}

std::string make_table(const std::vector<ComparisonRow>& rows) {
    std::string text =
        "| verdict | method | scene | what | BASE | NEW | change | margin | evidence |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const ComparisonRow& row : rows) {
        text += make_row(row);
    }
    return text;
}

std::string make_list(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += "- " + escape_markdown(line) + "\n";
    }
    return text;
}

std::string fold(const std::string& title, const std::string& body) {
    return fmt::format("\n<details><summary>{}</summary>\n\n{}\n</details>\n", title, body);
}

} // namespace

std::string make_comparison_markdown(const Comparison& comparison) {
    std::vector<ComparisonRow> changed = list_verdicts(comparison);
    const auto first_same =
        std::find_if(changed.begin(), changed.end(),
                     [](const ComparisonRow& row) { return row.verdict == Verdict::same; });
    const std::vector<ComparisonRow> same(first_same, changed.end());
    changed.erase(first_same, changed.end());
    std::string text =
        fmt::format("### Alcove: {}\n\nBASE {}, NEW {}\n\n", summarize_verdicts(comparison),
                    escape_markdown(comparison.base.name), escape_markdown(comparison.next.name));
    text += changed.empty() ? "Nothing changed beyond its margin.\n" : make_table(changed);
    text += "\n" + escape_markdown(describe_discoveries(comparison)) + ".\n";
    text += "\nImages:\n\n" + make_list(describe_images(comparison));
    if (const auto settings = describe_settings(comparison); !settings.empty()) {
        text += "\nSettings:\n\n" + make_list(settings);
    }
    if (const auto unpaired = describe_unpaired(comparison); !unpaired.empty()) {
        text += "\nNot compared:\n\n" + make_list(unpaired);
    }
    if (!same.empty()) {
        text += fold(fmt::format("{} verdicts: same", same.size()), make_table(same));
    }
    if (const auto parts = list_information(comparison); !parts.empty()) {
        text += fold("where the time went, without verdict", make_table(parts));
    }
    std::vector<std::string> how = comparison.notes;
    const std::vector<std::string> method = describe_method(comparison);
    how.insert(how.end(), method.begin(), method.end());
    return text + fold("how this was measured", make_list(how));
}

} // namespace alcove
