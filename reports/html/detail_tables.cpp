#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/round_section.hpp"

#include "core/base/text.hpp"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

namespace alcove {
namespace {

std::string fold(const char* title, const std::string& body) {
    return fmt::format("<details class=\"fold\"><summary>{}</summary>\n{}</details>\n", title,
                       body);
}

std::string make_error_rows(const CellAnalysis& cell, std::size_t index) {
    std::string text;
    const std::pair<const std::vector<MetricAnalysis>*, SampleState> tables[] = {
        {&cell.cold, SampleState::cold},
        {&cell.converged, SampleState::converged},
        {&cell.temporal, SampleState::cold}};
    for (const auto& [errors, state] : tables) {
        for (const MetricAnalysis& error : *errors) {
            if (error.frames == 0 && error.undefined == 0) {
                continue;
            }
            text += fmt::format(
                "<tr><th scope=\"row\" class=\"name\">{}</th><td class=\"text\">{}</td><td "
                "class=\"text\">{}</td>",
                make_label(cell, index), escape_html(error.metric), to_text(state));
            const auto add = [&](const std::optional<double>& value) {
                text += value ? fmt::format("<td>{}</td>", format_rounded(*value))
                              : "<td class=\"absent\">&ndash;</td>";
            };
            if (error.frames == 0) {
                text +=
                    fmt::format("<td class=\"absent\" colspan=\"4\">undefined on {} frames: {}</td>"
                                "<td>0</td></tr>\n",
                                error.undefined, escape_html(error.note));
                continue;
            }
            add(error.value);
            if (error.is_below_floor) {
                text += fmt::format("<td>{}</td>", escape_html(format_error(error)));
            } else {
                add(error.debiased);
            }
            add(error.floor);
            text += fmt::format("<td>{}..{}</td><td>{}", format_rounded(error.minimum),
                                format_rounded(error.maximum), error.frames);
            if (error.undefined > 0) {
                text += fmt::format("<small>{} undefined: {}</small>", error.undefined,
                                    escape_html(error.note));
            }
            text += "</td></tr>\n";
        }
    }
    return text;
}

std::string make_error_table(const RoundAnalysis& round) {
    std::string rows;
    for (std::size_t i = 0; i < round.cells.size(); ++i) {
        rows += make_error_rows(round.cells[i], i);
    }
    return "<p class=\"note\">Errors are measured against " +
           escape_html(round.round.reference.label) +
           ". Cold errors are over the frames of the bursts, converged ones over "
           "single "
           "frames with time and camera held. A method without history has its cold singles in the "
           "converged row. <i>&lt;</i> stands where the error is under the reference's own "
           "noise.</p>\n"
           "<div class=\"scroll\"><table><thead><tr><th class=\"name\">Method</th><th "
           "class=\"text\">Metric</th><th "
           "class=\"text\">State</th><th>Mean</th><th>Debiased</th><th>Floor</th>"
           "<th>Over frames</th><th>n frames</th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div>\n";
}

std::string make_number_cell(const std::optional<double>& value) {
    return value ? fmt::format("<td data-value=\"{}\">{}</td>", *value, format_rounded(*value, 3))
                 : std::string("<td></td>");
}

std::string make_pass_rows(const CellAnalysis& cell, std::size_t index) {
    double sum_ms = 0.0;
    for (const PassAnalysis& pass : cell.passes) {
        sum_ms += pass.is_input ? 0.0 : std::max(0.0, pass.time_ms.value);
    }
    std::string text;
    for (const PassAnalysis& pass : cell.passes) {
        const double share = pass.is_input || sum_ms <= 0.0 ? 0.0 : pass.time_ms.value / sum_ms;
        std::string marks;
        if (pass.is_under_resolution) {
            marks += fmt::format("<span class=\"mark\">under {:g} ticks</span>", kResolvedTicks);
        }
        if (pass.is_cached) {
            marks += "<span class=\"mark\">cached</span>";
        }
        const std::string bar =
            pass.is_input ? std::string("<span class=\"absent\">input cost</span>")
                          : fmt::format("<span class=\"bar\"><span class=\"{}\" "
                                        "style=\"width:{:.1f}%\"></span></span>"
                                        "<small>{:.0f} %</small>",
                                        get_series_class(cell, index),
                                        100.0 * std::clamp(share, 0.0, 1.0), 100.0 * share);
        text += fmt::format(
            "<tr><th scope=\"row\" class=\"name\">{}</th><td class=\"text\">{} {}</td>{}{}{}{}<td "
            "class=\"share\">{}</td>",
            make_label(cell, index), escape_html(pass.pass), marks,
            make_estimate_cell(pass.time_ms), make_number_cell(pass.ns_per_pixel),
            make_number_cell(pass.ns_per_sample), make_number_cell(pass.fetches_per_pixel), bar);
        text += &pass == &cell.passes.back() ? make_estimate_cell(cell.coverage) : "<td></td>";
        text += "</tr>\n";
    }
    return text;
}

std::string make_pass_table(const RunAnalysis& analysis, const RoundAnalysis& round) {
    std::string rows;
    for (std::size_t i = 0; i < round.cells.size(); ++i) {
        rows += make_pass_rows(round.cells[i], i);
    }
    return fmt::format(
        "<p class=\"note\">Passes are timed one by one on every second frame; dividing perturbs. "
        "Coverage is "
        "their sum over the undivided envelope: far from 1, trust the envelope. Input cost is the "
        "G-buffer "
        "with what the method declares minus the base G-buffer and may be negative. Pixels are the "
        "image's, at half resolution as well; samples those of the pass that takes them, where "
        "their "
        "number is fixed. Fetches from textures and images are counted with --count-fetches, over "
        "the image's pixels as well, and are the same on every device.</p>\n"
        "<div class=\"scroll\"><table><thead><tr><th class=\"name\">Method</th><th "
        "class=\"text\">Pass</th><th>Time<small>ms <em>{}</em></small></th><th>ns a "
        "pixel</th><th>ns "
        "a sample</th><th>Fetches a pixel</th><th class=\"share\">Share of its "
        "passes</th><th>Coverage</th></tr></thead><tbody>\n{}</tbody></table></div>\n",
        escape_html(analysis.context.device_class), rows);
}

std::string make_spread_table(const RunAnalysis& analysis, const RoundAnalysis& round) {
    std::string rows;
    for (std::size_t i = 0; i < round.cells.size(); ++i) {
        const CellAnalysis& cell = round.cells[i];
        if (!cell.content || !cell.noise || !cell.slow_frames) {
            continue;
        }
        rows += fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th>", make_label(cell, i));
        for (const double time_ms :
             {cell.content->p50_ms, cell.content->p95_ms, cell.content->p99_ms,
              cell.slow_frames->slowest_mean, cell.slow_frames->time_integral}) {
            rows += fmt::format("<td>{}</td>", format_rounded(time_ms, 4));
        }
        rows += fmt::format("<td>{}</td>", cell.content->n);
        for (const double time_ms : {cell.noise->p50_ms, cell.noise->p95_ms, cell.noise->p99_ms}) {
            rows += fmt::format("<td>{}</td>", format_rounded(time_ms, 4));
        }
        rows += cell.outliers ? fmt::format("<td>{} mild, {} severe</td>", cell.outliers->mild,
                                            cell.outliers->severe)
                              : "<td class=\"absent\">&ndash;</td>";
        rows += fmt::format("<td>{}</td>", cell.noise->n);
        rows += make_estimate_cell(cell.compose_ms) + "</tr>\n";
    }
    return fmt::format(
        "<p class=\"note\"><i>Content</i>: percentiles over frames of each frame's median over "
        "repeats, what the "
        "walkthrough asks. <i>Noise</i>: percentiles over repeats of each repeat's median over "
        "frames, what the "
        "machine adds; drift that all methods share falls out of the ratios. <i>Slowest 1 % of the "
        "time</i>: "
        "slowest frames first, until they have taken 1 % of the total; the time of the last. Of "
        "fewer "
        "than 150 frames both are about the slowest one. <i>Outliers</i>: repeats beyond 1.5 "
        "(mild) "
        "or 3 (severe) interquartile ranges from the quartiles, counted and kept. All in ms "
        "<em>{}</em>.</p>\n"
        "<div class=\"scroll\"><table><thead><tr><th rowspan=\"2\" class=\"name\">Method</th><th "
        "colspan=\"6\" "
        "class=\"group\">Content</th><th colspan=\"5\" class=\"group\">Noise</th><th "
        "rowspan=\"2\">Composition</th></tr><tr><th "
        "class=\"first\">p50</th><th>p95</th><th>p99</th>"
        "<th>Slowest 1 %<small>mean</small></th><th>Slowest 1 %<small>of the "
        "time</small></th><th>n "
        "frames</th><th "
        "class=\"first\">p50</th><th>p95</th><th>p99</th><th>Outliers</th><th>n "
        "repeats</th></tr></thead><tbody>\n{}</tbody></table></div>\n",
        escape_html(analysis.context.device_class), rows);
}

std::string make_parameter_table(const RoundAnalysis& round) {
    std::string rows;
    for (std::size_t i = 0; i < round.cells.size(); ++i) {
        const CellAnalysis& cell = round.cells[i];
        if (cell.cell.role != CellRole::method) {
            continue;
        }
        const CellRecord& record = cell.cell;
        rows += fmt::format(
            "<tr class=\"method\"><th scope=\"row\" class=\"name\">{}</th><td class=\"text\" "
            "colspan=\"5\">preset {}, target {}{}{}, {} warm frames, effects {}</td></tr>\n",
            make_label(cell, i), escape_html(record.preset), escape_html(record.target),
            record.target_note.empty() ? "" : "; ", escape_html(record.target_note),
            record.warm_frames, escape_html(record.effects));
        for (const ParameterRecord& parameter : record.parameters) {
            rows += "<tr><td></td>";
            for (const std::string* field : {&parameter.name, &parameter.symbol, &parameter.value,
                                             &parameter.unit, &parameter.provenance}) {
                rows += "<td class=\"text\">" + escape_html(*field) + "</td>";
            }
            rows += "</tr>\n";
        }
    }
    return "<div class=\"scroll\"><table><thead><tr><th class=\"name\">Method</th><th "
           "class=\"text\">Parameter</th><th class=\"text\">Symbol</th><th "
           "class=\"text\">Value</th><th "
           "class=\"text\">Unit</th><th class=\"text\">From</th></tr></thead><tbody>\n" +
           rows + "</tbody></table></div>\n";
}

} // namespace

std::string make_detail_tables(const RunAnalysis& analysis, const RoundAnalysis& round) {
    return fold("Errors with their floors", make_error_table(round)) +
           fold("Passes and coverage", make_pass_table(analysis, round)) +
           fold("Content and noise", make_spread_table(analysis, round)) +
           fold("Parameters and where they come from", make_parameter_table(round));
}

} // namespace alcove
