#include "reports/html/tune_page.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/page_head.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

namespace alcove {
namespace {

bool is_lower_better(const TuneRecord& record, const TuneJudgementRecord& judgement) {
    return judgement.is_objective ? record.objective_lower_is_better : record.judge_lower_is_better;
}

/// Marked only where the whole interval lies on one side.
const char* get_class(const TuneRecord& record, const TuneJudgementRecord& judgement) {
    const bool lower = is_lower_better(record, judgement);
    const bool is_better = lower ? judgement.upper < 0.0 : judgement.lower > 0.0;
    const bool is_worse = lower ? judgement.lower > 0.0 : judgement.upper < 0.0;
    return is_better ? "best" : is_worse ? "partly" : "";
}

std::string make_judgement_row(const TuneRecord& record, const TunedMethodRecord& method,
                               const TuneJudgementRecord& judgement) {
    const std::optional<double> gap = find_generalisation_gap(method, judgement);
    return fmt::format(
        "<tr><th scope=\"row\" class=\"name\">{}</th><td class=\"text\">{}</td><td "
        "class=\"text\">{}<small>{}</small></td><td>{}</td><td>{}</td><td class=\"{}\"><b>{}</b>"
        "<small>[{}, {}] (n={})</small></td><td>{}</td></tr>\n",
        escape_html(method.label), escape_html(judgement.set), escape_html(judgement.metric),
        judgement.is_objective ? "tuned on" : "not tuned on", format_rounded(judgement.before),
        format_rounded(judgement.after), get_class(record, judgement),
        format_rounded(judgement.change), format_rounded(judgement.lower),
        format_rounded(judgement.upper), judgement.frames,
        gap ? format_percent(*gap) : std::string("&ndash;"));
}

std::string make_judgements(const TuneRecord& record) {
    std::string rows;
    for (const TunedMethodRecord& method : record.methods) {
        for (const TuneJudgementRecord& judgement : method.judgements) {
            rows += make_judgement_row(record, method, judgement);
        }
    }
    return "<section><h2>Before and after</h2>\n<p class=\"note\">Means over frames; the change "
           "frame by frame, with its interval over frames: how content spreads it. Before: the "
           "method mapped to the target. Gap: the share of the gain on training frames that is "
           "lost on frames that were not fitted; over 100 %, it is worse than before "
           "there.</p>\n<div class=\"scroll\"><table class=\"wide\"><thead><tr><th "
           "class=\"name\">Method</th><th class=\"text\">Frames</th><th "
           "class=\"text\">Metric</th><th>Before</th><th>After</th><th>Change</"
           "th><th>Generalisation "
           "gap</th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div></section>\n";
}

std::string describe_attempts(const TunedMethodRecord& method) {
    std::string text;
    for (const double cost : method.least_costs) {
        text += (text.empty() ? "" : " and ") + format_rounded(cost, 4);
    }
    return text;
}

std::string make_parameters(const TunedMethodRecord& method) {
    std::string rows;
    for (const TuneParameterRecord& parameter : method.parameters) {
        rows += fmt::format(
            "<tr><th scope=\"row\" class=\"name\">{}</th><td class=\"text\">{}</td><td "
            "class=\"text\">{}</td><td>{}</td><td>{}</td></tr>\n",
            escape_html(parameter.name), escape_html(parameter.tuned), escape_html(parameter.unit),
            format_rounded(parameter.lower_ratio), format_rounded(parameter.upper_ratio));
    }
    return "<div class=\"scroll\"><table><thead><tr><th class=\"name\">Parameter</th><th "
           "class=\"text\">Tuned</th><th class=\"text\">Unit</th><th>Cost ratio<small>a tenth of "
           "its range lower</small></th><th>Cost ratio<small>a tenth "
           "higher</small></th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div>\n";
}

/// The least cost so far over evaluations, one line an attempt.
std::string draw_convergence(const TunedMethodRecord& method) {
    constexpr double kWidth = 460.0;
    constexpr double kHeight = 150.0;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const double cost : method.least_costs) {
        least = std::min(least, cost);
    }
    // The first guess of the grid can be far off: the axis ends at the worst running minimum behind
    // each attempt's first tenth.
    std::vector<std::vector<double>> curves(method.least_costs.size());
    for (const TuneEvaluationRecord& evaluation : method.history) {
        if (evaluation.attempt < 0 ||
            static_cast<std::size_t>(evaluation.attempt) >= curves.size()) {
            continue;
        }
        std::vector<double>& curve = curves[static_cast<std::size_t>(evaluation.attempt)];
        curve.push_back(curve.empty() ? evaluation.cost : std::min(curve.back(), evaluation.cost));
    }
    for (const std::vector<double>& curve : curves) {
        if (!curve.empty()) {
            most = std::max(most, curve[curve.size() / 10]);
        }
    }
    const double range = most > least ? most - least : 1.0;
    std::string lines;
    for (std::size_t attempt = 0; attempt < curves.size(); ++attempt) {
        std::string points;
        for (std::size_t i = 0; i < curves[attempt].size(); ++i) {
            const double x = kWidth * static_cast<double>(i + 1) /
                             static_cast<double>(std::max(method.evaluations, 1));
            const double y =
                std::clamp((curves[attempt][i] - least) / range, 0.0, 1.0) * (kHeight - 10.0);
            points += fmt::format("{:.1f},{:.1f} ", std::min(x, kWidth), kHeight - 5.0 - y);
        }
        lines += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"var(--series-{})\" "
                             "stroke-width=\"1.6\"/>",
                             points, 3 + attempt % 2);
    }
    return fmt::format(
        "<figure><svg viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" "
        "aria-label=\"least cost over evaluations\"><path d=\"M0 {1} H{0} M0 0 V{1}\" "
        "stroke=\"var(--line)\" fill=\"none\"/>{2}</svg><figcaption>Least cost so far, from {3} at "
        "the bottom to {4} at the top, over {5} evaluations; blue the first attempt, orange the "
        "restart from another seed.</figcaption></figure>\n",
        kWidth, kHeight, lines, format_rounded(least, 4), format_rounded(most, 4),
        method.evaluations);
}

std::string make_method(const TunedMethodRecord& method) {
    return fmt::format("<section><h2>{}<small>{}</small></h2>\n<p class=\"verdict\">{}: two "
                       "attempts end at "
                       "{}.</p>\n<p class=\"note\"><code>--method {}@{}</code></p>\n",
                       escape_html(method.label), escape_html(method.preset),
                       method.is_converged ? "Converged" : "Not converged",
                       describe_attempts(method), escape_html(method.method),
                       escape_html(method.calibration)) +
           make_parameters(method) + draw_convergence(method) + "</section>\n";
}

std::string make_scenes(const TuneRecord& record) {
    const auto list = [](const std::vector<int>& frames) {
        std::string text;
        for (const int frame : frames) {
            text += (text.empty() ? "" : ", ") + std::to_string(frame);
        }
        return text.empty() ? std::string("&ndash;") : text;
    };
    std::string rows;
    for (const TuneSceneRecord& scene : record.scenes) {
        rows += fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th><td "
                            "class=\"text\">{}</td><td class=\"text\">{}</td><td "
                            "class=\"text\">{}</td></tr>\n",
                            escape_html(scene.scene), escape_html(scene.target),
                            list(scene.training), list(scene.held_out));
    }
    return "<section><h2>Frames</h2><div class=\"scroll\"><table><thead><tr><th "
           "class=\"name\">Scene</th><th class=\"text\">Target</th><th class=\"text\">Training "
           "frames</th><th class=\"text\">Held-out frames</th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div></section>\n";
}

} // namespace

std::string make_tune_page(const TuneRecord& record) {
    std::string text =
        make_page_head("tune", {}, {"stability.css"}) +
        fmt::format(
            "<header><p class=\"brand\">Alcove<span>ambient occlusion, measured</span></p>\n"
            "<h1>Calibration</h1>\n<p class=\"verdict\">Tuned on {}, judged also by {}; {} "
            "evaluations a free parameter and attempt, a coarse grid first.</p>\n"
            "<p class=\"command\"><code>{}</code></p>\n<p class=\"command\">{} x {} pixels, {}, "
            "build {}, {}, seed {}</p></header>\n<main>\n",
            escape_html(record.objective), escape_html(record.judge),
            record.evaluations_per_parameter, escape_html(record.command_line), record.width,
            record.height, escape_html(describe_device(record.context)),
            escape_html(record.context.build_id), escape_html(record.context.started_utc),
            record.seed) +
        make_judgements(record);
    for (const TunedMethodRecord& method : record.methods) {
        text += make_method(method);
    }
    return text + make_scenes(record) + "</main></body></html>\n";
}

} // namespace alcove
