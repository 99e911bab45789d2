#include "reports/html/round_section.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/events.hpp"
#include "reports/html/explanation_block.hpp"
#include "reports/html/film.hpp"
#include "reports/html/strata_table.hpp"
#include "reports/html/temporal_tables.hpp"

#include <fmt/core.h>

namespace alcove {
namespace {

std::string make_facts(const RoundAnalysis& round) {
    const RoundRecord& record = round.round;
    std::size_t bursts = 0;
    std::size_t frames = 0;
    for (const SegmentRecord& segment : record.segments) {
        bursts += segment.is_single() ? 0 : 1;
        frames += static_cast<std::size_t>(segment.end - segment.begin);
    }
    return fmt::format(
        "<dl "
        "class=\"facts\"><div><dt>Walkthrough</dt><dd>{}</dd></div><div><dt>Size</"
        "dt><dd>{}&times;{}</dd>"
        "</div><div><dt>Target</dt><dd>{}</dd></div><div><dt>Measured</dt><dd>{}</dd></div>"
        "<div><dt>Errors against</dt><dd>{}</dd></div><div><dt>Replayed</dt><dd>{} frames: {} "
        "bursts, {} singles, "
        "{} repeats{}</dd></div><div><dt>Scene</dt><dd>{} triangles, AO radius {} m</dd></div>"
        "<div><dt>Precision</dt><dd>{}</dd></div></dl>\n",
        escape_html(record.walkthrough), record.width, record.height, escape_html(record.target),
        measures_pictures(record) ? "picture" : "visibility", escape_html(record.reference.label),
        frames, bursts, record.segments.size() - bursts, round.done.repeats.taken,
        record.warm ? ", histories converged on the first pose of each" : "",
        record.scene_triangles, format_rounded(record.ao_radius_m), escape_html(record.precision));
}

std::string make_charts(const RoundAnalysis& round) {
    return fmt::format(
        "<div class=\"charts\" data-charts=\"{}\">\n"
        "<figure data-chart=\"scatter\"><figcaption>Time against error<small>Left "
        "is faster. Bars: interval or extremes, of times over repeats, of errors over frames. "
        "Line: "
        "the front.</small></figcaption></figure>\n"
        "<figure data-chart=\"times\"><figcaption>Frame time<small>Envelope, cold; "
        "median over repeats, band "
        "min..max. Bursts side by side.</small></figcaption></figure>\n"
        "<figure data-chart=\"errors\"><figcaption>Error over frames<small>Cold: "
        "history starts {} in every burst. Dashed: reference floor. Metrics over time and numbers "
        "of histories too.</small></figcaption></figure>\n"
        "</div>\n",
        round.round.id, round.round.warm ? "converged" : "empty");
}

std::string make_cost_note(const RoundAnalysis& round) {
    const RoundDone& done = round.done;
    return fmt::format("<p class=\"note\">This round took {} s: G-buffer {} s, passes {} s, "
                       "metrics {} s, over time {} s, "
                       "reference {} s{}, "
                       "pictures {} s.</p>\n",
                       format_rounded(done.wall_s), format_rounded(done.gbuffer_s),
                       format_rounded(done.passes_s), format_rounded(done.metrics_s),
                       format_rounded(done.temporal_s), format_rounded(done.reference_s),
                       done.reference_cached ? " (from the cache)" : "",
                       format_rounded(done.images_s));
}

/// A round's scene is the text as it was asked for: "lifted_box:speed=fast" is the scene
/// lifted_box; the path of a file, which may hold a ':', is a name of its own.
std::string find_title(const RunAnalysis& analysis, const std::string& scene) {
    for (const std::string& name : {scene, scene.substr(0, scene.find(':'))}) {
        for (const SceneDescription& description : analysis.plan.scenes) {
            if (description.name == name) {
                return description.title;
            }
        }
    }
    return {};
}

std::string make_over_time(const RunAnalysis& analysis, const RoundAnalysis& round,
                           const PictureFinder& finder) {
    const std::string text = make_temporal_table(analysis, round) +
                             make_history_table(analysis, round) +
                             make_convergence_table(analysis, round) +
                             make_event_list(round.round) + make_film_block(round, finder);
    return text.empty() ? text
                        : "<div class=\"over-time\"><h3>Over time</h3>\n" + text + "</div>\n";
}

} // namespace

std::string make_round_section(const RunAnalysis& analysis, const RoundAnalysis& round,
                               const PictureFinder& finder) {
    const std::string title = find_title(analysis, round.round.scene);
    std::string text =
        fmt::format("<section class=\"round\" id=\"round-{}\">\n<h2>{}{}</h2>\n", round.round.id,
                    escape_html(round.round.scene),
                    title.empty() ? "" : "<small>" + escape_html(title) + "</small>");
    text += fmt::format("<p class=\"verdict\">{}</p>\n<p class=\"fitness\">{}; {}.</p>\n",
                        escape_html(describe_verdict(round)), escape_html(describe_noise(round)),
                        escape_html(describe_floor(round)));
    for (const std::string& line :
         {describe_fitness(round.machine), describe_repeats(analysis, round),
          describe_outliers(round), describe_effects(round)}) {
        text += line.empty() ? "" : fmt::format("<p class=\"fitness\">{}</p>\n", escape_html(line));
    }
    text += make_facts(round) + make_summary_table(analysis, round) + make_charts(round);
    if (!round.round.image_frames.empty()) {
        text += fmt::format("<h3>Pictures</h3>\n<div class=\"viewer\" data-viewer=\"{}\"></div>\n",
                            round.round.id);
        text += fmt::format("<p class=\"note\">The reference is {}. {}red is too dark, blue too "
                            "bright, light grey is exact.</p>\n",
                            escape_html(round.round.reference.label),
                            measures_pictures(round.round)
                                ? "Pictures are direct light and what the method adds to it, "
                                  "behind the tone curve of Reinhard et al. 2002 with white at "
                                  "4, as sRGB; errors are those of these pictures. Error map, of "
                                  "luminance: "
                                : "Error map: ");
        text += make_picture_sheet(round, finder);
    }
    return text + make_over_time(analysis, round, finder) + make_strata_tables(analysis, round) +
           make_explanation_block(round, finder) + make_detail_tables(analysis, round) +
           make_cost_note(round) + "</section>\n";
}

} // namespace alcove
