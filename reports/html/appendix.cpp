#include "reports/html/appendix.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"

#include <algorithm>
#include <initializer_list>

#include <fmt/core.h>

namespace alcove {
namespace {

/// A row of text cells, the first as its head.
std::string make_row(std::initializer_list<std::string> fields) {
    std::string text = "<tr>";
    bool is_first = true;
    for (const std::string& field : fields) {
        text += is_first ? "<th scope=\"row\" class=\"name\">" + escape_html(field) + "</th>"
                         : "<td class=\"text\">" + escape_html(field) + "</td>";
        is_first = false;
    }
    return text + "</tr>\n";
}

std::string make_table(std::initializer_list<const char*> columns, const std::string& rows) {
    std::string head;
    for (const char* column : columns) {
        head += fmt::format("<th class=\"text\">{}</th>", column);
    }
    if (!head.empty()) {
        head = "<thead><tr>" + head + "</tr></thead>";
    }
    return fmt::format("<div class=\"scroll\"><table>{}<tbody>\n{}</tbody></table></div>\n", head,
                       rows);
}

std::string make_trial_table(const ContextRecord& context) {
    std::string rows;
    for (const TimerTrialRecord& trial : context.timer_trials) {
        rows += make_row({trial.mode, trial.sequence, std::to_string(trial.pass),
                          std::to_string(trial.attempt + 1), format_rounded(trial.ratio, 4),
                          trial.accepted ? "accepted" : "refused"});
    }
    if (rows.empty()) {
        return "<p class=\"note\">No timer trials are recorded.</p>\n";
    }
    return "<h3>Timer trials</h3>\n<p class=\"note\">A known load, pass by pass, over the same "
           "pass run alone "
           "under wall clock. A mode counts only if every pass is within 5 %. D is a draw, C a "
           "dispatch.</p>\n" +
           make_table({"Mode", "Sequence", "Pass", "Attempt", "Ratio (median of 9)", "Verdict"},
                      rows);
}

struct Definition {
    const char* name;
    const char* text;
};

constexpr Definition kDefinitions[] = {
    {"Time, × anchor",
     "The method's envelope over the anchor's on the same frame of the same repeat: the median "
     "over "
     "frames of the log ratio in each repeat, then mean and Student t across repeats. The anchor "
     "is "
     "one pass of 32 depth fetches. Only this number is comparable between rounds and runs."},
    {"AO, ms", "All passes of the method timed as one piece: the median over frames in each "
               "repeat, then mean and 95 % "
               "interval across repeats. Belongs to the device it is printed with."},
    {"AO converged, ms",
     "The same with scene time and camera held until the history is full, on the first and last "
     "single frame. A method without history has one value in both columns."},
    {"Input, ms", "The G-buffer with the channels, layers, views and border a method declares "
                  "minus the base G-buffer "
                  "(eye depth, normal, albedo, direct light). Measured, not clamped: may be "
                  "negative. Marked when it "
                  "comes from a cache."},
    {"Frame, ms", "Base G-buffer + input + AO + composition, added repeat by repeat."},
    {"[a, b] (n=6)",
     "95 % interval across n repeats. Under 5 repeats there is none: a..b are the extremes."},
    {"Cold, converged", "Cold: as replayed, history reset at the start of each segment, or "
                        "converged on its first pose "
                        "where a round says so; error tables take the bursts. "
                        "Converged: held still; error tables take the single frames."},
    {"Debiased, floor",
     "The reference is the mean of two independent halves. Debiased errors are cross products of "
     "the "
     "halves, free of the reference's noise. The floor is what that noise alone would give; "
     "differences under it print as < floor."},
    {"Over time",
     "Metrics over time follow bursts: means over the burst frames that have a value, cold. What "
     "methods say of their history is a mean over surface pixels and frames."},
    {"Front", "No other method of the round is both faster (× anchor) and more accurate. Errors "
              "under the floor count as "
              "the floor; times closer than the noise are ordered, but not told apart."},
    {"Coverage", "Sum of the passes timed one by one over the envelope."},
    {"Content, noise", "Percentiles over frames are content, over repeats noise."},
    {"A/A, minimum detectable effect",
     "The anchor is timed twice in every round. The larger distance from 1 of the ends "
     "of their ratio's interval: smaller effects are not told from noise."},
};

std::string describe_metric(const MetricDescription& metric) {
    return fmt::format("<dt>{}<small>{}</small></dt><dd>{} Computed on {}{}{}; {}. "
                       "<b>Blind to:</b> {}</dd>\n",
                       escape_html(metric.name), escape_html(metric.title),
                       escape_html(metric.definition), escape_html(metric.domain),
                       metric.unit.empty() ? "" : ", unit ", escape_html(metric.unit),
                       metric.kind == "history"
                           ? "neither good nor bad"
                           : (metric.lower_is_better ? "lower is better" : "higher is better"),
                       metric.blind_to.empty() ? "not stated." : escape_html(metric.blind_to));
}

} // namespace

std::string make_unfinished_section(const RunAnalysis& analysis) {
    std::string rows;
    std::size_t unfinished = 0;
    for (const RoundRecord& round : analysis.plan.rounds) {
        const bool is_finished = std::any_of(
            analysis.rounds.begin(), analysis.rounds.end(),
            [&](const RoundAnalysis& finished) { return finished.round.id == round.id; });
        if (is_finished) {
            continue;
        }
        ++unfinished;
        bool has_rows = false;
        for (const ProvisionalRow& row : analysis.provisional) {
            if (row.round == round.id) {
                has_rows = true;
                rows += fmt::format(
                    "<tr><th scope=\"row\" class=\"name\">{}</th><td class=\"text\">{}</td><td>{}"
                    "<small>(n=1)</small></td><td class=\"text\"><span "
                    "class=\"mark\">provisional</span></td></tr>\n",
                    escape_html(row.label), escape_html(round.scene), format_rounded(row.time_ms));
            }
        }
        if (!has_rows) {
            rows += fmt::format(
                "<tr><th scope=\"row\" class=\"name\">&ndash;</th><td class=\"text\">{}</td><td "
                "class=\"absent\">&ndash;</td><td class=\"text\">waiting</td></tr>\n",
                escape_html(round.scene));
        }
    }
    if (unfinished == 0) {
        return {};
    }
    return fmt::format(
        "<section id=\"unfinished\"><h2>Not finished yet</h2>\n<p class=\"note\">Provisional times "
        "are "
        "one sample of a round that is still running. They are shown to see that things move, and "
        "compared with nothing.</p>\n<div class=\"scroll\"><table><thead><tr><th "
        "class=\"name\">Method</th><th class=\"text\">Scene</th><th>AO<small>ms "
        "<em>{}</em></small></th><th "
        "class=\"text\">State</th></tr></thead><tbody>\n{}</tbody></table>"
        "</div></section>\n",
        escape_html(analysis.context.device_class), rows);
}

std::string make_skipped_section(const RunAnalysis& analysis) {
    if (analysis.plan.skipped.empty()) {
        return {};
    }
    std::string rows;
    for (const SkippedRecord& skipped : analysis.plan.skipped) {
        rows += make_row({skipped.what, skipped.reason});
    }
    return "<section id=\"skipped\"><h2>Left out</h2>\n" + make_table({"What", "Reason"}, rows) +
           "</section>\n";
}

std::string make_environment_section(const RunAnalysis& analysis) {
    const ContextRecord& context = analysis.context;
    const PlanRecord& plan = analysis.plan;
    std::string rows;
    const auto add = [&](const char* name, const std::string& value) {
        rows += make_row({name, value});
    };
    add("Command", plan.command_line);
    add("Started", context.started_utc);
    add("Device", describe_device(context));
    add("OpenGL", context.gl_vendor + ", " + context.gl_version);
    add("Processor", fmt::format("{}, {} threads", context.cpu, context.cpu_threads));
    add("Processor features", context.cpu_features);
    add("Timer", describe_timer(analysis));
    add("Build",
        fmt::format("{} ({}, {})", context.build_id, context.build_type, context.compiler));
    add("Anchor version", context.anchor_version);
    add("Repeats", std::to_string(plan.repeats));
    add("Shuffle seed", std::to_string(plan.shuffle_seed));
    add("Reference", fmt::format("2 halves of {} rays a pixel", plan.reference_rays_per_half));
    return "<section id=\"environment\"><h2>Environment</h2>\n" + make_table({}, rows) +
           make_trial_table(context) + "</section>\n";
}

std::string make_definitions_section(const RunAnalysis& analysis) {
    std::string text = "<section id=\"definitions\"><h2>Definitions</h2>\n<h3>Numbers</h3>\n<dl "
                       "class=\"definitions\">\n";
    for (const Definition& definition : kDefinitions) {
        text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape_html(definition.name),
                            escape_html(definition.text));
    }
    text += "</dl>\n<h3>Metrics</h3>\n<dl class=\"definitions\">\n";
    for (const MetricDescription& metric : analysis.plan.metrics) {
        // The table of strata tells its own.
        text += metric.kind == kStratumKind ? std::string() : describe_metric(metric);
    }
    std::string methods;
    for (const MethodDescription& method : analysis.plan.methods) {
        methods += make_row({method.name, method.title, method.citation, method.content_hash});
    }
    std::string scenes;
    for (const SceneDescription& scene : analysis.plan.scenes) {
        scenes +=
            make_row({scene.name, scene.title, scene.stresses, scene.license, scene.content_hash});
    }
    return text + "</dl>\n<h3>Methods</h3>\n" +
           make_table({"Method", "Title", "After", "Content hash"}, methods) +
           "<h3>Scenes and their licences</h3>\n" +
           make_table({"Scene", "Title", "Stresses", "Licence", "Content hash"}, scenes) +
           "</section>\n";
}

} // namespace alcove
