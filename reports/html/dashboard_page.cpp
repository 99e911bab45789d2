#include "reports/html/dashboard_page.hpp"

#include "reports/analysis/history_wording.hpp"
#include "reports/html/dashboard_findings.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/web_files.hpp"

#include <algorithm>
#include <vector>

#include <fmt/core.h>

namespace alcove {
namespace {

std::string make_head() {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
        "'unsafe-inline'; script-src 'unsafe-inline'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<title>Alcove: dashboard</title>\n<style>{}{}</style></head><body>\n",
        find_web_file("page.css"), find_web_file("dashboard.css"));
}

std::string make_header(const StoredHistory& history) {
    std::string text = fmt::format(
        "<header><p class=\"brand\">Alcove<span>ambient occlusion, measured</span></p>\n"
        "<h1>Nights</h1>\n<p class=\"note\">{} nights, {} series",
        history.runs.size(), history.series.size());
    if (!history.runs.empty()) {
        text += fmt::format(", {} to {}", escape_html(history.runs.front().utc),
                            escape_html(history.runs.back().utc));
    }
    return text + "</p></header>\n";
}

/// Series of one place, in the store's order: the methods of a scene stand together.
struct Group {
    SeriesName place; ///< without method, state, pass and metric
    std::vector<const ShownSeries*> series;
};

std::vector<Group> group_series(const std::vector<ShownSeries>& shown) {
    std::vector<Group> groups;
    std::map<SeriesName, std::size_t> indices;
    for (const ShownSeries& one : shown) {
        SeriesName place = one.series->name;
        for (std::string* part :
             {&place.method, &place.effects, &place.state, &place.pass, &place.metric}) {
            part->clear();
        }
        const auto [found, is_new] = indices.emplace(place, groups.size());
        if (is_new) {
            groups.push_back({place, {}});
        }
        groups[found->second].series.push_back(&one);
    }
    for (Group& group : groups) {
        std::stable_sort(group.series.begin(), group.series.end(),
                         [](const ShownSeries* a, const ShownSeries* b) {
                             return a->series->name.method < b->series->name.method;
                         });
    }
    return groups;
}

std::string describe_interval(const StoredPoint& point, SeriesKind kind) {
    if (!point.interval) {
        return fmt::format("n={}", point.n);
    }
    return fmt::format("[{}, {}] n={}", describe_value(kind, point.interval->lower),
                       describe_value(kind, point.interval->upper), point.n);
}

std::string make_row(const ShownSeries& shown) {
    const StoredSeries& series = *shown.series;
    if (series.points.empty()) {
        return {};
    }
    const StoredPoint& last = series.points.back();
    std::string baseline;
    std::string change;
    std::string fence;
    if (!shown.nights.empty()) {
        const HistoryNight& night = shown.nights.back();
        const HistoryRule rule = get_rule(series.kind);
        if (night.baseline) {
            baseline = describe_value(series.kind, *night.baseline);
            change = describe_change(series.kind, to_change(*night.difference, rule));
        }
        if (night.fence) {
            fence = describe_change(series.kind, to_change(*night.fence, rule)).substr(1);
        }
    }
    const bool is_image = series.kind == SeriesKind::images;
    const bool is_time = series.kind != SeriesKind::quality && !is_image;
    const std::string under = is_image ? last.image_hash
                                       : describe_interval(last, series.kind) +
                                             (is_time ? ", " + shown.device_class : "");
    return fmt::format(
        "<tr><th scope=\"row\" class=\"name\">{}</th><td class=\"text\">{}</td><td><b>{}</b>"
        "<small>{}</small></td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
        escape_html(series.name.method), escape_html(describe_series(series.kind, series.name)),
        describe_value(series.kind, last.value), escape_html(under), baseline, change, fence,
        series.points.size(),
        std::count_if(series.verdicts.begin(), series.verdicts.end(),
                      [](const StoredVerdict& verdict) { return verdict.is_confirmed; }));
}

std::string make_charts(const std::vector<const ShownSeries*>& series) {
    std::string text;
    std::string method;
    for (const ShownSeries* one : series) {
        const std::string figure = make_history_figure(*one);
        if (figure.empty()) {
            continue;
        }
        if (text.empty() || one->series->name.method != method) {
            method = one->series->name.method;
            text += text.empty() ? "" : "</div>\n";
            text += fmt::format("<h3>{}</h3>\n<div class=\"charts\">\n", escape_html(method));
        }
        text += figure;
    }
    return text.empty() ? text : text + "</div>\n";
}

std::string make_group(const Group& group) {
    std::string rows;
    for (const ShownSeries* one : group.series) {
        rows += make_row(*one);
    }
    return fmt::format(
        "<section><h2>{}<small>{}</small></h2>\n<p class=\"note\">{}</p>\n"
        "<details{}><summary>{} series, their last night</summary><div class=\"scroll\"><table>"
        "<thead><tr><th class=\"name\">Method</th><th class=\"text\">Series</th><th>Last</th>"
        "<th>Baseline</th><th>Change</th><th>Fence</th><th>Nights</th><th>Steps</th></tr></thead>"
        "<tbody>\n{}</tbody></table></div></details>\n{}</section>\n",
        escape_html(group.place.scene), escape_html(group.place.suite),
        escape_html(describe_place(group.place) + ", " + group.place.precision + "; " +
                    group.place.device),
        find_web_file("dashboard.js").empty() ? " open" : "", group.series.size(), rows,
        make_charts(group.series));
}

std::string make_legend() {
    std::string text =
        "<section><h2>How to read this</h2><ul>\n<li>charts: the value with its 95 % interval, "
        "dashed the baseline, grey the fence, thin grey milliseconds (right axis); upright lines: "
        "steps, dashed where the second measurement did not repeat them; a gap: another segment, "
        "what lies on its two sides is not compared</li>\n"
        "<li>numbers of one device say nothing of another</li>\n";
    for (const std::string& line : describe_rules()) {
        text += "<li>" + escape_html(line) + "</li>\n";
    }
    return text + "</ul></section>\n";
}

std::string make_notice() {
    if (find_web_file("dashboard.js").empty()) {
        return "<p class=\"notice\">charts are not built in: run <code>npm ci</code> and build "
               "again</p>\n";
    }
    return "<p class=\"notice plain\">Charts need JavaScript. Last night's numbers stand in the "
           "tables, all nights in the store.</p>\n";
}

std::string make_script(const StoredHistory& history, const std::vector<ShownSeries>& shown) {
    const std::string_view bundle = find_web_file("dashboard.js");
    if (bundle.empty()) {
        return {};
    }
    return fmt::format(
        "<script type=\"application/json\" id=\"data\">{}</script>\n<script>{}</script>\n",
        make_dashboard_data(history, shown), bundle);
}

} // namespace

std::string make_dashboard_page(const StoredHistory& history) {
    const std::vector<ShownSeries> shown = replay_series(history);
    std::string page = make_head() + make_header(history) + "<main>\n" + make_notice() +
                       make_findings_sections(history, shown);
    for (const Group& group : group_series(shown)) {
        page += make_group(group);
    }
    return page + make_legend() + "</main>\n" + make_script(history, shown) + "</body></html>\n";
}

} // namespace alcove
