#include "reports/html/comparison_page.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/comparison_wording.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/page_head.hpp"
#include "reports/html/pictures.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace alcove {
namespace {

/// Pairs that are shown of a cell, those that differ most, so that a film does not drown the page.
constexpr std::size_t kShownPairs = 4;

std::string make_row(const ComparisonRow& row) {
    const std::string verdict = row.verdict ? std::string(to_text(*row.verdict)) : "";
    const char* mark = row.verdict == Verdict::better ? "state"
                       : row.verdict == Verdict::same ? ""
                                                      : "mark";
    return fmt::format(
        "<tr><td class=\"text\"><span class=\"{}\">{}</span></td><th scope=\"row\" "
        "class=\"name\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}</td>"
        "<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"text\">{}</td>"
        "<td class=\"text\">{}</td></tr>\n",
        row.verdict ? mark : "", verdict, escape_html(row.cell->base.label),
        escape_html(row.cell->round.scene), escape_html(row.what), escape_html(row.base),
        escape_html(row.next), escape_html(row.change), escape_html(row.margin),
        escape_html(row.p_holm), escape_html(row.p_bh), escape_html(row.ranks),
        escape_html(row.note));
}

std::string make_table(const std::vector<ComparisonRow>& rows) {
    std::string text =
        "<div class=\"scroll\"><table><thead><tr><th class=\"text\">Verdict</th><th "
        "class=\"name\">Method</th><th class=\"text\">Scene</th><th class=\"text\">What</th>"
        "<th>BASE</th><th>NEW</th><th>Change</th><th>Margin</th><th>p (Holm)</th><th>p (BH)</th>"
        "<th class=\"text\">By ranks</th><th></th></tr></thead><tbody>\n";
    for (const ComparisonRow& row : rows) {
        text += make_row(row);
    }
    return text + "</tbody></table></div>\n";
}

std::string make_list(const char* title, const std::vector<std::string>& lines) {
    if (lines.empty()) {
        return {};
    }
    std::string text = fmt::format("<section><h2>{}</h2><ul>\n", title);
    for (const std::string& line : lines) {
        text += "<li>" + escape_html(line) + "</li>\n";
    }
    return text + "</ul></section>\n";
}

std::string make_pairs(const CellComparison& cell, const PictureFinder& base,
                       const PictureFinder& next) {
    std::vector<PictureChange> pictures = cell.images.pictures;
    std::stable_sort(pictures.begin(), pictures.end(),
                     [](const PictureChange& a, const PictureChange& b) {
                         return a.mean_difference.value_or(0.0) > b.mean_difference.value_or(0.0);
                     });
    pictures.resize(std::min(kShownPairs, pictures.size()));
    std::string text;
    for (const PictureChange& picture : pictures) {
        const auto image = [&](const PictureFinder& finder, const std::string& path,
                               const char* side) {
            return fmt::format("<td><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}, {2}, frame {3}\" "
                               "width=\"{4}\" height=\"{5}\" loading=\"lazy\"></a></td>",
                               finder.make_url(path), escape_html(cell.base.label), side,
                               picture.frame, cell.round.width, cell.round.height);
        };
        text += fmt::format(
            "<tr><th scope=\"row\" class=\"name\">frame {}<small>{}</small></th>{}{}</tr>\n",
            picture.frame,
            picture.mean_difference ? fmt::format("mean |difference| {} codes",
                                                  format_rounded(*picture.mean_difference))
                                    : std::string("other sizes"),
            image(base, picture.base, "BASE"), image(next, picture.next, "NEW"));
    }
    return fmt::format(
        "<h3>{} in {}<small> {} of {} pairs</small></h3><div class=\"scroll\"><table "
        "class=\"pictures\"><thead><tr><th class=\"name\">Frame</th><th>BASE</th><th>NEW</th></tr>"
        "</thead><tbody>\n{}</tbody></table></div>\n",
        escape_html(cell.base.label), escape_html(cell.round.scene), pictures.size(),
        cell.images.pictures.size(), text);
}

std::string make_pictures(const Comparison& comparison, const std::filesystem::path& folder) {
    const PictureFinder base(comparison.base.folder, folder);
    const PictureFinder next(comparison.next.folder, folder);
    std::string text;
    for (const CellComparison& cell : comparison.cells) {
        if (!cell.images.pictures.empty()) {
            text += make_pairs(cell, base, next);
        }
    }
    return text.empty() ? text : "<section><h2>Changed pictures</h2>\n" + text + "</section>\n";
}

std::string make_header(const Comparison& comparison) {
    return fmt::format(
        "<header><p class=\"brand\">Alcove<span>ambient occlusion, measured</span></p>\n"
        "<h1>{}</h1>\n<p class=\"command\">BASE {} <code>{}</code></p>\n"
        "<p class=\"command\">NEW {} <code>{}</code></p></header>\n",
        summarize_verdicts(comparison), escape_html(comparison.base.name),
        escape_html(comparison.base.command_line), escape_html(comparison.next.name),
        escape_html(comparison.next.command_line));
}

} // namespace

std::string make_comparison_page(const Comparison& comparison,
                                 const std::filesystem::path& folder) {
    std::vector<std::string> how = comparison.notes;
    const std::vector<std::string> method = describe_method(comparison);
    how.insert(how.end(), method.begin(), method.end());
    return make_page_head("comparison", {.shows_pictures = true}) + make_header(comparison) +
           "<main>\n<section><h2>Verdicts</h2>\n" + make_table(list_verdicts(comparison)) +
           "<p class=\"note\">" + escape_html(describe_discoveries(comparison)) + ".</p>\n" +
           "</section>\n" + make_list("Images", describe_images(comparison)) +
           make_pictures(comparison, folder) +
           make_list("Settings", describe_settings(comparison)) +
           make_list("Not compared", describe_unpaired(comparison)) +
           "<section><h2>Where the time went, and histories</h2>\n" +
           make_table(list_information(comparison)) + "</section>\n" +
           make_list("How this was measured", how) + "</main></body></html>\n";
}

} // namespace alcove
