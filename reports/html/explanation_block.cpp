#include "reports/html/explanation_block.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/explanation.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/round_section.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace alcove {
namespace {

std::string name_thickness(double thickness) {
    return std::isinf(thickness) ? "infinite" : format_rounded(thickness) + " r";
}

/// Squared visibility in units of 1e-6: errors of 1/1000 are 1.
std::string make_moment_cell(double value) {
    return fmt::format("<td data-value=\"{}\">{}</td>", format_number(value),
                       format_rounded(value * 1e6));
}

std::string make_steps_table(const std::vector<ExplainedError>& explained) {
    std::string rows;
    for (const ExplainedError& entry : explained) {
        const StepRecord& mean = entry.mean;
        const std::string none = "<td class=\"absent\">none</td>";
        rows += fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th><td>{}</td>",
                            make_breakable(entry.label), name_thickness(entry.thickness));
        rows += make_moment_cell(mean.total);
        rows += mean.has_converged_form ? make_moment_cell(mean.d1) : none;
        rows += make_moment_cell(mean.d2) + make_moment_cell(mean.d3);
        rows += mean.has_converged_form ? make_moment_cell(2.0 * mean.d1_d2) : none;
        rows += mean.has_converged_form ? make_moment_cell(2.0 * mean.d1_d3) : none;
        rows += make_moment_cell(2.0 * mean.d2_d3) + make_moment_cell(mean.truth_noise) +
                make_moment_cell(mean.march_noise) +
                fmt::format("<td>{}</td></tr>\n", entry.frames);
    }
    return "<div class=\"scroll\"><table class=\"wide\" data-sortable><thead><tr><th "
           "class=\"name\">Method</th><th>Thickness<small>of the march</small></th><th "
           "data-sort>Total</th><th data-sort>d1&sup2;<small>samples, noise, "
           "filters</small></th><th data-sort>d2&sup2;<small>the estimator</small></th><th "
           "data-sort>d3&sup2;<small>one depth layer</small></th><th data-sort>2 d1 d2</th><th "
           "data-sort>2 d1 d3</th><th data-sort>2 d2 d3</th><th data-sort>Truth's "
           "noise</th><th data-sort>March's noise</th><th>Frames</th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div>\n";
}

std::string describe_thicknesses(const RoundDone& done) {
    std::string text;
    for (const ThicknessRecord& record : done.thicknesses) {
        text +=
            fmt::format("{}{}: {}{}", text.empty() ? "" : ", ", name_thickness(record.thickness),
                        format_rounded(record.mse * 1e6), record.is_best ? " (best)" : "");
    }
    return text;
}

/// The curve in a square of 120 px, its diagonal dotted.
std::string draw_curve(const CurveRecord& curve) {
    std::string points;
    for (std::size_t i = 0; i < curve.visibility.size(); ++i) {
        points += fmt::format("{:.1f},{:.1f} ", 120.0 * std::clamp(curve.visibility[i], 0.0, 1.0),
                              120.0 * (1.0 - std::clamp(curve.curved[i], 0.0, 1.0)));
    }
    return fmt::format(
        "<svg class=\"curve\" viewBox=\"0 0 120 120\" width=\"120\" height=\"120\" role=\"img\" "
        "aria-label=\"best monotone curve\"><path d=\"M0 120 L120 0\" stroke=\"currentColor\" "
        "stroke-dasharray=\"2 3\" opacity=\"0.5\" fill=\"none\"/><polyline points=\"{}\" "
        "fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.5\"/></svg>",
        points);
}

std::string make_curve_table(const std::vector<CurveAnalysis>& curves) {
    std::string rows;
    for (const CurveAnalysis& curve : curves) {
        const std::string held_out =
            curve.rmse_held_out
                ? fmt::format("<td data-value=\"{}\"><b>{}</b><small>{} of it</small></td>",
                              format_number(*curve.rmse_held_out),
                              format_rounded(*curve.rmse_held_out),
                              format_rounded(*curve.rmse_held_out / curve.rmse))
                : std::string("<td class=\"absent\">&ndash;</td>");
        rows += fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th><td "
                            "data-value=\"{}\"><b>{}</b></td><td data-value=\"{}\">{}</td>{}<td>{}"
                            "</td><td>{}</td></tr>\n",
                            make_breakable(curve.label), format_number(curve.rmse),
                            format_rounded(curve.rmse), format_number(curve.rmse_fitted),
                            format_rounded(curve.rmse_fitted), held_out, curve.curve.frames,
                            draw_curve(curve.curve));
    }
    return "<h4>What a curve would mend</h4>\n<p class=\"note\">The best monotone curve from a "
           "method's visibility to truth's, over single frames: what a slider or a power can do "
           "for it at most is no error of shape. Held out: fitted on every second frame, judged on "
           "the others. Truth's own noise is part of all three. The picture: visibility of the "
           "method to the right, what the curve makes of it upwards; the diagonal changes "
           "nothing.</p>\n<div class=\"scroll\"><table class=\"wide\" data-sortable><thead><tr><th "
           "class=\"name\">Method</th><th data-sort>rmse</th><th data-sort>behind its "
           "curve<small>on the same frames</small></th><th data-sort>behind its curve<small>held "
           "out</small></th><th>Frames</th><th>Curve</th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div>\n";
}

std::string make_step_pictures(const RoundAnalysis& round, const PictureFinder& finder) {
    static const std::vector<PictureKind> kKinds{
        {"step1", "d1: method - converged form", false, "step1"},
        {"step2_infinite", "d2: - march, infinite", false, "step2_infinite"},
        {"step3_infinite", "d3: march, infinite - truth", true, "step3_infinite"},
        {"step2_best", "d2: - march, best thickness", false, "step2_best"},
        {"step3_best", "d3: march, best thickness - truth", true, "step3_best"}};
    std::string text;
    for (const int frame : round.round.image_frames) {
        const std::string table = make_picture_table(round, finder, frame, kKinds, "none");
        if (table.find("<img") != std::string::npos) {
            text += fmt::format(
                "<details class=\"fold\"><summary>Steps of frame {}</summary>{}</details>\n", frame,
                table);
        }
    }
    return text.empty() ? text
                        : "<p class=\"note\">Step maps: red is too dark, blue too bright; full "
                          "colour at 0.25, half of an error map's.</p>\n" +
                              text;
}

} // namespace

std::string make_explanation_block(const RoundAnalysis& round, const PictureFinder& finder) {
    const std::vector<ExplainedError> explained = explain_errors(round);
    if (explained.empty()) {
        return {};
    }
    double worst = 0.0;
    for (const ExplainedError& entry : explained) {
        worst = std::max(worst, std::abs(entry.closure));
    }
    return fmt::format(
               "<div class=\"explanation\"><h3>Errors in steps</h3>\n<p class=\"note\">Mean "
               "squares "
               "over the round's single frames, in 1e-6 of squared visibility: total = "
               "d1&sup2; + d2&sup2; + d3&sup2; + the three cross terms, to {} at worst. d1 = "
               "method "
               "- its converged form, d2 = converged form (or the method, where it has none) - "
               "brute-force march over the depth buffer, d3 = march - truth: what one depth layer "
               "with a constant thickness cannot know. Steps may cancel: no shares. Thickness "
               "against truth: {}.</p>\n",
               format_rounded(worst, 1), escape_html(describe_thicknesses(round.done))) +
           make_steps_table(explained) + make_step_pictures(round, finder) +
           make_curve_table(analyze_curves(round)) + "</div>\n";
}

} // namespace alcove
