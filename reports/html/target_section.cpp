#include "reports/html/target_section.hpp"

#include "reports/analysis/target_ranking.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/round_section.hpp"

#include <algorithm>
#include <array>

#include <fmt/core.h>

namespace alcove {
namespace {

struct SettingsTable {
    const char* settings;
    const char* title;
    const char* note;
};

constexpr std::array kTables{
    SettingsTable{"common", "Common target",
                  "Each method maps the target to its own radius and falloff; what it cannot do is "
                  "said in its row."},
    SettingsTable{"calibrated", "Calibrated",
                  "Free parameters fitted to the target on frames that are not judged here."},
    SettingsTable{"native", "Native settings",
                  "As methods come, for whatever they were made: rows are never compared with each "
                  "other or with those above."}};

std::string make_settings_table(const RankedTarget& target, const SettingsTable& table,
                                const TargetRanking& ranking) {
    std::string rows;
    for (const RankedCell& cell : target.cells) {
        if (cell.settings == table.settings) {
            rows += fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th><td>{}</td>{}<td "
                                "class=\"text\">{}</td></tr>\n",
                                make_breakable(cell.label),
                                cell.place ? std::to_string(*cell.place) : "&ndash;",
                                make_estimate_cell(cell.error), escape_html(cell.note));
        }
    }
    if (rows.empty()) {
        return {};
    }
    return fmt::format(
        "<h4>{}</h4><p class=\"note\">{}</p><div class=\"scroll\"><table class=\"wide\"><thead>"
        "<tr><th class=\"name\">Method</th><th>Place</th><th>{}<small>{}</small></th><th "
        "class=\"text\">What of the target it cannot do</th></tr></thead><tbody>\n{}</tbody>"
        "</table></div>\n",
        table.title, table.note, escape_html(ranking.metric), to_text(ranking.state), rows);
}

/// A row a method, a column a target.
std::string make_ranking_table(const TargetRanking& ranking) {
    std::string head;
    for (const RankedTarget& target : ranking.targets) {
        head += fmt::format("<th class=\"text\">{}</th>", make_breakable(target.target));
    }
    std::string rows;
    for (const RankedCell& cell : ranking.targets.front().cells) {
        if (!cell.place) {
            continue;
        }
        const bool moves = std::find(ranking.moved.begin(), ranking.moved.end(), cell.label) !=
                           ranking.moved.end();
        rows +=
            fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th>", make_breakable(cell.label));
        for (const RankedTarget& target : ranking.targets) {
            const RankedCell* other = ranking.find(target, cell.label);
            rows += other == nullptr || !other->place
                        ? std::string("<td class=\"absent\">&ndash;</td>")
                        : fmt::format("<td data-value=\"{}\"><b>{}</b><small>{}</small></td>",
                                      *other->place, *other->place,
                                      format_estimate(other->error).value);
        }
        rows += fmt::format("<td class=\"text\">{}</td></tr>\n", moves ? "changes place" : "");
    }
    return fmt::format(
        "<h4>Places over targets</h4><p class=\"note\">Place of each method by its mean error, and "
        "the error, under each target. {}</p><div class=\"scroll\"><table class=\"wide\">"
        "<thead><tr><th class=\"name\">Method</th>{}<th class=\"text\"></th></tr></thead><tbody>\n"
        "{}</tbody></table></div>\n",
        ranking.moved.empty()
            ? std::string("No place changes.")
            : fmt::format("{} of {} change place.", ranking.moved.size(),
                          std::count_if(ranking.targets.front().cells.begin(),
                                        ranking.targets.front().cells.end(),
                                        [](const RankedCell& c) { return c.place.has_value(); })),
        head, rows);
}

std::string make_ranking(const TargetRanking& ranking) {
    std::string text = fmt::format(
        "<details open class=\"fold\"><summary>{} {}&times;{}</summary>\n<p class=\"note\">{}, {}, "
        "against {}.</p>\n",
        escape_html(ranking.scene), ranking.width, ranking.height, escape_html(ranking.walkthrough),
        escape_html(ranking.precision), escape_html(ranking.reference));
    if (ranking.targets.size() > 1) {
        text += make_ranking_table(ranking);
    }
    for (const RankedTarget& target : ranking.targets) {
        text += fmt::format("<h3>{}</h3>\n", escape_html(target.target));
        for (const SettingsTable& table : kTables) {
            text += make_settings_table(target, table, ranking);
        }
    }
    return text + "</details>\n";
}

} // namespace

std::string make_target_section(const RunAnalysis& analysis) {
    const std::vector<TargetRanking> rankings = rank_targets(analysis);
    if (rankings.empty()) {
        return {};
    }
    std::string text =
        "<section id=\"targets\">\n<h2>Targets</h2>\n<p class=\"note\">An error is one against a "
        "target: radius, falloff, weighting, normals. Brackets are how content spreads an error "
        "(over single frames, or over bursts), not how well it is known; equal places are equal, "
        "or under the reference's floor.</p>\n";
    for (const TargetRanking& ranking : rankings) {
        text += make_ranking(ranking);
    }
    return text + "</section>\n";
}

} // namespace alcove
