#include "reports/html/reproduction_index.hpp"

#include "reports/html/escape.hpp"
#include "reports/html/page_head.hpp"

#include <fmt/core.h>

namespace alcove {

std::string make_reproduction_index(std::span<const IndexedReproduction> papers) {
    std::string page = make_page_head("reproductions of papers", {});
    page += "<header><h1>Reproductions of papers</h1></header>\n<main>\n<div class=\"scroll\">"
            "<table><thead><tr><th class=\"text\">Paper</th>";
    for (const OutcomeCount& count : count_outcomes({})) {
        page += fmt::format("<th>{}</th>", to_text(count.outcome));
    }
    page += "</tr></thead><tbody>\n";
    for (const IndexedReproduction& paper : papers) {
        page += fmt::format("<tr><td class=\"text\"><a href=\"{}/index.html\">{}</a>: {}</td>",
                            escape_html(escape_url_path(paper.folder)),
                            escape_html(paper.reproduction.paper),
                            escape_html(paper.reproduction.citation));
        for (const OutcomeCount& count : count_outcomes(paper.reproduction.verdicts)) {
            page += fmt::format("<td>{}</td>", count.claims);
        }
        page += "</tr>\n";
    }
    return page + "</tbody></table></div>\n</main></body></html>\n";
}

} // namespace alcove
