#include "reports/html/html_report.hpp"

#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/html/appendix.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/page_data.hpp"
#include "reports/html/page_head.hpp"
#include "reports/html/pictures.hpp"
#include "reports/html/round_section.hpp"
#include "reports/html/target_section.hpp"
#include "reports/html/tradeoff_section.hpp"
#include "reports/html/web_files.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace alcove {

namespace {

/// One tile of the strip that says whether the machine was fit to measure.
std::string make_tile(std::string_view title, const std::string& value, const std::string& note) {
    return fmt::format("<div class=\"tile\"><h2>{}</h2><p>{}</p><small>{}</small></div>\n", title,
                       escape_html(value), escape_html(note));
}

std::string make_fitness(const RunAnalysis& analysis) {
    const ContextRecord& context = analysis.context;
    std::optional<double> noise;
    std::string floor = "none";
    std::string floor_note = "no finished round has a floor yet";
    double worst = 0.0;
    const Fitness* machine = nullptr;
    for (const RoundAnalysis& round : analysis.rounds) {
        if (machine == nullptr || round.machine.verdict > machine->verdict) {
            machine = &round.machine;
        }
        if (round.minimum_detectable_effect) {
            noise = std::max(noise.value_or(0.0), *round.minimum_detectable_effect);
        }
        if (round.reference_floor && *round.reference_floor > worst) {
            worst = *round.reference_floor;
            floor = format_rounded(worst) + " " + round.front_metric;
            floor_note = "largest, in " + round.round.scene;
        }
    }
    return "<div class=\"tiles\">\n" +
           make_tile("Device", context.device_class,
                     fmt::format("{}, {} threads", context.gl_renderer, context.driver_threads)) +
           make_tile("Timer", analysis.is_timer_validated ? "validated" : "fenced wall time",
                     fmt::format("{}, tick {} ns", context.timer_mode,
                                 format_rounded(context.timer_tick_ns))) +
           make_tile(
               "Machine", machine != nullptr ? std::string(to_text(machine->verdict)) : "unknown",
               machine == nullptr         ? "no round is finished yet"
               : machine->reasons.empty() ? "other processes, guests and the clock left it alone"
                                          : "worst round: " + machine->reasons.front()) +
           make_tile("Noise", noise ? format_percent(*noise) : "unknown",
                     "smallest time difference told from noise (A/A, worst round)") +
           make_tile("Reference floor", floor, floor_note) + "</div>\n";
}

std::string make_header(const RunAnalysis& analysis, bool in_progress) {
    const std::size_t planned = analysis.plan.rounds.size();
    std::string state;
    if (in_progress) {
        state = fmt::format(
            "<span class=\"state running\" role=\"status\">in progress: {} of {}</span>",
            analysis.rounds.size(), count_rounds(planned));
    } else if (!analysis.is_complete) {
        state = fmt::format("<span class=\"state running\" role=\"status\">incomplete: {} of {}; "
                            "continue with "
                            "<code>--resume</code></span>",
                            analysis.rounds.size(), count_rounds(planned));
    } else {
        state = fmt::format("<span class=\"state\" role=\"status\">complete: {}</span>",
                            count_rounds(planned));
    }
    return fmt::format(
        "<header><p class=\"brand\">Alcove<span>ambient occlusion, "
        "measured</span></p>\n<h1>{}</h1>{}\n"
        "<p class=\"command\"><code>{}</code></p>\n<p class=\"note\">{}</p>\n{}</header>\n",
        escape_html(analysis.plan.experiment), state, escape_html(analysis.plan.command_line),
        escape_html(analysis.context.started_utc), make_fitness(analysis));
}

std::string make_navigation(const RunAnalysis& analysis, bool has_targets, bool has_tradeoff) {
    std::string text = "<nav aria-label=\"Sections\">";
    for (const RoundAnalysis& round : analysis.rounds) {
        text += fmt::format("<a href=\"#round-{}\">{}</a>", round.round.id,
                            escape_html(round.round.scene));
    }
    if (has_targets) {
        text += "<a href=\"#targets\">Targets</a>";
    }
    if (has_tradeoff) {
        text += "<a href=\"#tradeoff\">Time against accuracy</a>";
    }
    if (!analysis.is_complete) {
        text += "<a href=\"#unfinished\">Not finished</a>";
    }
    if (!analysis.plan.skipped.empty()) {
        text += "<a href=\"#skipped\">Left out</a>";
    }
    return text + "<a href=\"#environment\">Environment</a><a "
                  "href=\"#definitions\">Definitions</a></nav>\n";
}

std::string make_script(const RunAnalysis& analysis, const PictureFinder& finder) {
    const std::string_view bundle = find_web_file("report.js");
    if (bundle.empty()) {
        return {};
    }
    return fmt::format(
        "<script type=\"application/json\" id=\"data\">{}</script>\n<script>{}</script>\n",
        make_page_data(analysis, finder), bundle);
}

std::string make_chart_notice() {
    if (find_web_file("report.js").empty()) {
        return "<p class=\"notice\">charts are not built in: run <code>npm ci</code> and build "
               "again</p>\n";
    }
    return "<p class=\"notice plain\">Charts, the picture viewer and the film need JavaScript. "
           "Every number "
           "they draw stands in "
           "the tables or in <code>samples.csv</code>.</p>\n";
}

std::string make_footer(const PictureFinder& finder) {
    std::string text = "<footer><p>This folder can be read without the program that made it:";
    for (const char* file :
         {"summary.csv", "passes.csv", "tradeoff.csv", "targets.csv", "explanation.csv",
          "strata.csv", "samples.csv", "metrics.csv", "plan.json", "context.json"}) {
        text += fmt::format(" <a href=\"{}\">{}</a>", finder.make_url(file), file);
    }
    return text + "</p></footer>\n";
}

} // namespace

void write_html_report(const RunFolder& run, const HtmlOptions& options) {
    const std::filesystem::path folder = options.out.empty() ? run.path() / "report" : options.out;
    const PictureFinder finder(run.path(), folder);
    const RunAnalysis analysis = analyze_run(run, options.provisional);
    const std::string targets = make_target_section(analysis);
    const std::string tradeoff = make_tradeoff_section(analysis);
    std::string page = make_page_head(analysis.plan.experiment, {true, true}, {"report.css"}) +
                       make_header(analysis, options.in_progress) +
                       make_navigation(analysis, !targets.empty(), !tradeoff.empty()) + "<main>\n" +
                       make_chart_notice();
    for (const RoundAnalysis& round : analysis.rounds) {
        page += make_round_section(analysis, round, finder);
    }
    page += targets + tradeoff + make_unfinished_section(analysis) +
            make_skipped_section(analysis) + make_environment_section(analysis) +
            make_definitions_section(analysis) + "</main>\n" + make_footer(finder) +
            make_script(analysis, finder) + "</body></html>\n";
    write_file_atomically(folder / "index.html", page);
}

} // namespace alcove
