#include "reports/html/reproduction_page.hpp"

#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/page_head.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace alcove {
namespace {

/// Longer tables are folded.
constexpr std::size_t kLongTable = 30;

std::string make_verdict_row(const ClaimVerdict& verdict) {
    const Claim& claim = verdict.claim;
    const char* mark = verdict.outcome == Outcome::fails          ? "mark"
                       : verdict.outcome == Outcome::inconclusive ? "state running"
                       : verdict.outcome == Outcome::holds        ? "state"
                                                                  : "";
    return fmt::format(
        "<tr id=\"{0}\"><td class=\"text\"><span class=\"{1}\">{2}</span></td><th scope=\"row\" "
        "class=\"name\">{0}</th><td class=\"text\">{3}</td><td class=\"text\">{4}: {5} {6}</td>"
        "<td class=\"text\">{7}</td><td>{8}</td><td class=\"text\">{9}</td></tr>\n",
        escape_html(claim.id), mark, to_text(verdict.outcome), escape_html(claim.location),
        escape_html(claim.quantity), escape_html(claim.value), escape_html(claim.unit),
        escape_html(verdict.tested),
        verdict.measured ? escape_html(describe_estimate(*verdict.measured)) : "",
        escape_html(verdict.why));
}

std::string make_verdict_table(const Reproduction& reproduction, Outcome outcome) {
    std::string rows;
    std::size_t count = 0;
    for (const ClaimVerdict& verdict : reproduction.verdicts) {
        if (verdict.outcome == outcome) {
            rows += make_verdict_row(verdict);
            ++count;
        }
    }
    if (count == 0) {
        return {};
    }
    const bool is_open = outcome == Outcome::fails || outcome == Outcome::inconclusive;
    return fmt::format(
        "<details{}><summary><strong>{}</strong>: {}</summary>\n<div class=\"scroll\"><table>"
        "<thead><tr><th class=\"text\">Verdict</th><th class=\"name\">Claim</th><th "
        "class=\"text\">Where</th><th class=\"text\">Published</th><th class=\"text\">Tested, on "
        "any hardware</th><th>Measured</th><th class=\"text\">On what, or why not</th></tr>"
        "</thead><tbody>\n{}</tbody></table></div></details>\n",
        is_open ? " open" : "", to_text(outcome), count, rows);
}

std::string make_table(const PaperTable& table) {
    std::string text = "<div class=\"scroll\"><table><thead><tr>";
    for (const std::string& column : table.columns) {
        text += "<th class=\"text\">" + escape_html(column) + "</th>";
    }
    text += "</tr></thead><tbody>\n";
    for (const std::vector<std::string>& row : table.rows) {
        text += "<tr>";
        for (const std::string& field : row) {
            text += "<td class=\"text\">" + escape_html(field) + "</td>";
        }
        text += "</tr>\n";
    }
    text += "</tbody></table></div>\n";
    if (table.rows.size() > kLongTable) {
        text = fmt::format("<details><summary>{} rows</summary>{}</details>\n", table.rows.size(),
                           text);
    }
    return fmt::format("<section id=\"{0}\"><h3>{1}</h3><p class=\"note\">{2}; <a "
                       "href=\"tables/{0}.csv\">CSV</a>, <a href=\"tables/{0}.tex\">LaTeX</a></p>\n"
                       "{3}</section>\n",
                       escape_html(table.id), escape_html(table.title), escape_html(table.note),
                       text);
}

std::string make_figure(const PaperFigure& figure) {
    std::string text =
        fmt::format("<section><h3>{}</h3><p class=\"note\">{}</p>\n<div class=\"scroll\"><table>"
                    "<tbody><tr>\n",
                    escape_html(figure.title), escape_html(figure.note));
    std::string captions;
    for (const FigurePicture& picture : figure.pictures) {
        text +=
            fmt::format("<td><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" loading=\"lazy\">"
                        "</a></td>\n",
                        escape_html(escape_url_path(picture.path)), escape_html(picture.caption));
        captions += "<td class=\"text\">" + escape_html(picture.caption) + "</td>";
    }
    return text + "</tr><tr>" + captions + "</tr></tbody></table></div></section>\n";
}

std::string make_errata(const Reproduction& reproduction) {
    std::string text = "<details><summary>Errata: where print or its extraction is ambiguous, and "
                       "how it is read here</summary>\n<ul>\n";
    for (const Erratum& erratum : reproduction.errata) {
        text += fmt::format("<li><strong>{}</strong>: {}. Read as: {}.</li>\n",
                            escape_html(erratum.location), escape_html(erratum.printed),
                            escape_html(erratum.reading));
    }
    return text + "</ul></details>\n";
}

} // namespace

std::string make_reproduction_page(const Reproduction& reproduction) {
    std::string page =
        make_page_head("reproduction of " + reproduction.paper, {.shows_pictures = true});
    page += fmt::format("<header><h1>Reproduction of {}</h1><p>{}</p></header>\n<main>\n",
                        escape_html(reproduction.paper), escape_html(reproduction.citation));
    page += fmt::format(
        "<p class=\"verdict\">{}.</p>\n<p class=\"fitness\">Scale {}; {}. A claim is judged on the "
        "form that does not depend on the hardware, by the 95 % interval of what was measured: it "
        "holds if the whole interval does, fails if none of it does. Scenes are ours, in place of "
        "the paper's.</p>\n",
        escape_html(describe_counts(reproduction)), escape_html(reproduction.scale),
        escape_html(describe_device(reproduction.context)));
    page += "<section><h2>Claims</h2>\n";
    for (const Outcome outcome :
         {Outcome::fails, Outcome::inconclusive, Outcome::holds, Outcome::not_testable}) {
        page += make_verdict_table(reproduction, outcome);
    }
    page += make_errata(reproduction) + "</section>\n<section><h2>Tables and figures' data</h2>\n";
    for (const PaperTable& table : reproduction.tables) {
        page += make_table(table);
    }
    page += "</section>\n<section><h2>Figures</h2>\n";
    for (const PaperFigure& figure : reproduction.figures) {
        page += make_figure(figure);
    }
    return page + "</section>\n</main></body></html>\n";
}

} // namespace alcove
