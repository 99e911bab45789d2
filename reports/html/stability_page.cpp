#include "reports/html/stability_page.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/stability_wording.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/page_head.hpp"

#include <fmt/core.h>

namespace alcove {
namespace {

const char* get_class(const StabilityCellRecord& cell) {
    switch (cell.outcome) {
    case StabilityOutcome::holds:
        return "holds";
    case StabilityOutcome::holds_up_to:
        return "partly";
    case StabilityOutcome::fails:
        return "fails";
    case StabilityOutcome::not_applicable:
        break;
    }
    return "absent";
}

std::string make_matrix_cell(const StabilityCaseRecord& described,
                             const StabilityCellRecord& cell) {
    if (cell.outcome == StabilityOutcome::not_applicable) {
        return fmt::format("<td class=\"absent\" title=\"{}\">n/a</td>", escape_html(cell.reason));
    }
    const std::string text = describe_outcome(described, cell);
    const std::size_t split = text.rfind(' ');
    return fmt::format("<td class=\"{}\"><a href=\"#{}\"><b>{}</b></a><small>{}</small></td>",
                       get_class(cell), escape_html(described.name),
                       escape_html(text.substr(0, split)), escape_html(text.substr(split + 1)));
}

/// A label that may break behind its separators, not within a word.
std::string make_heading(const std::string& label) {
    std::string text;
    for (const char c : escape_html(label)) {
        text += c;
        text += c == '@' || c == ':' || c == '_' || c == ',' ? "<wbr>" : "";
    }
    return text;
}

std::string make_matrix(const StabilityRecord& record) {
    std::string text = "<div class=\"scroll wide\"><table class=\"matrix\"><thead><tr><th "
                       "class=\"name\">Case</th>";
    for (const StabilityMethodRecord& method : record.methods) {
        text += fmt::format("<th>{}</th>", make_heading(method.label));
    }
    text += "</tr></thead><tbody>\n";
    for (const StabilityCaseRecord& described : record.cases) {
        text += fmt::format("<tr><th scope=\"row\" class=\"name\"><a href=\"#{}\">{}</a></th>",
                            escape_html(described.name), escape_html(described.title));
        for (const StabilityMethodRecord& method : record.methods) {
            text += make_matrix_cell(described, find_cell(record, described.name, method.label));
        }
        text += "</tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

std::string make_score_cell(const StabilityScoreRecord& score) {
    const std::string note = score.fault.empty()
                                 ? fmt::format("bound {}", format_rounded(score.bound))
                                 : escape_html(score.fault);
    return fmt::format("<td class=\"{}\"><b>{}</b><small>{}</small></td>",
                       holds(score) ? "holds" : "fails", format_rounded(score.score), note);
}

std::string make_scores(const StabilityRecord& record, const StabilityCaseRecord& described) {
    std::string text = fmt::format("<div class=\"scroll\"><table><thead><tr><th class=\"name\">{}, "
                                   "mild to harsh</th>",
                                   escape_html(described.axis));
    for (const StabilitySeverityRecord& severity : described.severities) {
        text += fmt::format("<th>{}</th>", escape_html(severity.label));
    }
    text += "</tr></thead><tbody>\n";
    for (const StabilityMethodRecord& method : record.methods) {
        const StabilityCellRecord& cell = find_cell(record, described.name, method.label);
        text +=
            fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th>", escape_html(method.label));
        if (cell.scores.empty()) {
            text += fmt::format("<td class=\"absent text\" colspan=\"{}\">not applicable: {}</td>",
                                described.severities.size(), escape_html(cell.reason));
        }
        for (const StabilityScoreRecord& score : cell.scores) {
            text += make_score_cell(score);
        }
        text += "</tr>\n";
    }
    return text + "</tbody></table></div>\n";
}

std::string make_pictures(const StabilityRecord& record, const StabilityCaseRecord& described) {
    std::string text;
    for (const StabilityMethodRecord& method : record.methods) {
        const StabilityCellRecord& cell = find_cell(record, described.name, method.label);
        for (std::size_t i = 0; i < cell.scores.size(); ++i) {
            if (cell.scores[i].picture.empty()) {
                continue;
            }
            const std::string caption = method.label + ", " + described.severities[i].label;
            text += fmt::format("<figure><img src=\"{}\" alt=\"visibility: {}\" loading=\"lazy\">"
                                "<figcaption>{}</figcaption></figure>\n",
                                escape_url_path(cell.scores[i].picture), escape_html(caption),
                                escape_html(caption));
        }
    }
    return text.empty() ? text
                        : "<p class=\"note\">What failed, at the mildest and the harshest severity "
                          "(visibility as eyes get it):</p>\n<div class=\"shots\">" +
                              text + "</div>\n";
}

std::string make_case(const StabilityRecord& record, const StabilityCaseRecord& described) {
    std::string text = fmt::format("<section id=\"{}\"><h2>{}<small>{}</small></h2>\n",
                                   escape_html(described.name), escape_html(described.title),
                                   escape_html(described.name));
    text += "<dl class=\"about\">\n";
    const auto add = [&text](const char* term, const std::string& meaning) {
        text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, escape_html(meaning));
    };
    add("Trigger", described.trigger);
    add("Must hold", described.invariant);
    add("Score", described.score + ", in " + described.score_unit + "; lower is better");
    add("Bound", described.bound_reason);
    add("Source", described.source);
    return text + "</dl>\n" + make_scores(record, described) + make_pictures(record, described) +
           "</section>\n";
}

std::string make_header(const StabilityRecord& record) {
    return fmt::format(
        "<header><p class=\"brand\">Alcove<span>ambient occlusion, measured</span></p>\n"
        "<h1>Hard cases</h1>\n<p class=\"verdict\">{}.</p>\n"
        "<p class=\"command\"><code>{}</code></p>\n<p class=\"command\">{} x {} pixels, {}, build "
        "{}, {}</p></header>\n",
        escape_html(summarize_stability(record)), escape_html(record.command_line), record.width,
        record.height, escape_html(describe_device(record.context)),
        escape_html(record.context.build_id), escape_html(record.context.started_utc));
}

} // namespace

std::string make_stability_page(const StabilityRecord& record) {
    std::string text = make_page_head("stability", {.shows_pictures = true}, {"stability.css"}) +
                       make_header(record) + "<main>\n<section><h2>Methods by case</h2>\n" +
                       make_matrix(record) +
                       "<p class=\"note\">The number is the worst (bound - score) / bound over all "
                       "severities: 1 is perfect, 0 just holds. x: a fault (NaN, infinity, "
                       "visibility outside [0,1], a background that is not exactly 1), or a bound "
                       "of 0 that is not met. A failure is a finding about the method; its README "
                       "says what is known of it.</p>\n</section>\n";
    for (const StabilityCaseRecord& described : record.cases) {
        text += make_case(record, described);
    }
    return text + "</main></body></html>\n";
}

} // namespace alcove
