#include "reports/html/dashboard_findings.hpp"

#include "reports/analysis/history_wording.hpp"
#include "reports/html/escape.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

namespace alcove {
namespace {

/// Steps of earlier nights that are listed.
constexpr std::size_t kShownSteps = 50;
constexpr std::size_t kDay = 10; ///< of "2026-03-04T05:06:07Z"

struct Finding {
    const ShownSeries* shown = nullptr;
    const StoredVerdict* verdict = nullptr;
};

using RunsById = std::map<std::int64_t, const StoredRun*>;

bool is_bad(const StoredVerdict& verdict) {
    return verdict.is_confirmed &&
           (verdict.kind == StepKind::slower || verdict.kind == StepKind::worse ||
            verdict.kind == StepKind::image_changed);
}

std::string describe_verdict(const StoredVerdict& verdict) {
    const std::string text(to_text(verdict.kind));
    return verdict.is_confirmed ? text : text + ", not repeated";
}

/// `text`, a link only where the folder lies below the store's.
std::string make_run_link(const StoredRun& run, const std::string& text) {
    const std::filesystem::path folder(run.folder);
    const bool is_below = !run.folder.empty() && folder.is_relative() &&
                          std::find(folder.begin(), folder.end(), "..") == folder.end();
    if (!is_below) {
        return escape_html(text);
    }
    return fmt::format("<a href=\"../{}/report/index.html\">{}</a>", escape_url_path(run.folder),
                       escape_html(text));
}

std::string make_row(const Finding& finding, const RunsById& runs) {
    const StoredSeries& series = *finding.shown->series;
    const StoredVerdict& verdict = *finding.verdict;
    const StoredRun& run = *runs.at(verdict.run);
    const bool is_image = verdict.kind == StepKind::image_changed;
    const auto describe = [&](double change) { return describe_change(series.kind, change); };
    const bool is_time = has_logarithm(series.kind);
    return fmt::format(
        "<tr><td class=\"text\"><span class=\"{}\">{}</span></td><th scope=\"row\" "
        "class=\"name\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}{}</td><td><b>{}</b>"
        "</td><td><b>{}</b></td><td><b>{}</b></td><td class=\"text\"><b>{}</b></td></tr>\n",
        is_bad(verdict)        ? "mark"
        : verdict.is_confirmed ? "state"
                               : "",
        describe_verdict(verdict), escape_html(series.name.method),
        escape_html(describe_place(series.name)),
        escape_html(describe_series(series.kind, series.name)),
        is_time ? fmt::format("<small>{}</small>", escape_html(finding.shown->device_class)) : "",
        is_image ? "" : describe(verdict.change), is_image ? "" : describe(verdict.fence).substr(1),
        verdict.second ? describe(*verdict.second) : "",
        make_run_link(run, run.utc.substr(0, kDay)));
}

std::string make_table(const std::vector<Finding>& findings, const RunsById& runs) {
    std::string text =
        "<div class=\"scroll\"><table><thead><tr><th class=\"text\">Verdict</th><th "
        "class=\"name\">Method</th><th class=\"text\">Where</th><th class=\"text\">What</th>"
        "<th>Change</th><th>Fence</th><th>Measured again</th><th class=\"text\">Night</th></tr>"
        "</thead><tbody>\n";
    for (const Finding& finding : findings) {
        text += make_row(finding, runs);
    }
    return text + "</tbody></table></div>\n";
}

std::string make_last_night(const StoredRun& run, std::vector<Finding> findings,
                            const RunsById& runs) {
    std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
        return is_bad(*a.verdict) > is_bad(*b.verdict);
    });
    std::string text =
        fmt::format("<section><h2>Last night of {}<small>{}, build {} {}</small></h2>\n"
                    "<p class=\"note\">{}</p>\n",
                    escape_html(run.suite), make_run_link(run, run.utc), escape_html(run.build),
                    escape_html(run.commit), escape_html(run.device));
    if (findings.empty()) {
        return text + "<p class=\"verdict\">Nothing left its fence.</p></section>\n";
    }
    text += make_table(findings, runs) + "<div class=\"charts\">\n";
    for (const Finding& finding : findings) {
        text += make_history_figure(*finding.shown);
    }
    return text + "</div></section>\n";
}

} // namespace

std::string make_history_figure(const ShownSeries& shown) {
    const StoredSeries& series = *shown.series;
    if (series.kind == SeriesKind::images || series.kind == SeriesKind::milliseconds) {
        return {}; // drawn as marks and beside the time of their cell
    }
    return fmt::format("<figure data-series=\"{}\"><figcaption>{}<small>{}, {}</small></figcaption>"
                       "</figure>\n",
                       series.id, escape_html(describe_series(series.kind, series.name)),
                       escape_html(series.name.method), escape_html(describe_unit(shown)));
}

std::string make_findings_sections(const StoredHistory& history,
                                   const std::vector<ShownSeries>& shown) {
    RunsById runs;
    std::map<std::pair<std::string, std::string>, const StoredRun*> last;
    for (const StoredRun& run : history.runs) {
        runs[run.id] = &run;
        last[{run.device, run.suite}] = &run;
    }
    std::map<std::int64_t, std::vector<Finding>> of_last;
    std::vector<Finding> earlier;
    for (const ShownSeries& one : shown) {
        for (const StoredVerdict& verdict : one.series->verdicts) {
            const StoredRun& run = *runs.at(verdict.run);
            if (last.at({run.device, run.suite}) == &run) {
                of_last[run.id].push_back({&one, &verdict});
            } else if (verdict.is_confirmed) {
                earlier.push_back({&one, &verdict});
            }
        }
    }
    std::string text;
    for (const auto& [key, run] : last) {
        text += make_last_night(*run, of_last[run->id], runs);
    }
    std::stable_sort(earlier.begin(), earlier.end(), [](const Finding& a, const Finding& b) {
        return a.verdict->run > b.verdict->run;
    });
    if (!earlier.empty()) {
        const std::size_t all = earlier.size();
        earlier.resize(std::min(all, kShownSteps));
        text += fmt::format("<section><h2>Earlier steps<small>the newest {} of {}</small></h2>\n{}"
                            "</section>\n",
                            earlier.size(), all, make_table(earlier, runs));
    }
    return text;
}

} // namespace alcove
