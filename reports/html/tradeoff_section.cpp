#include "reports/html/tradeoff_section.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/tradeoff.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/html/escape.hpp"
#include "reports/html/round_section.hpp"

#include <fmt/core.h>

namespace alcove {
namespace {

/// Longer tables start closed: about one screen of rows.
constexpr std::size_t kMostOpenRows = 16;

constexpr const char* kNothing = "<td class=\"absent text\">&ndash;</td>";

const char* name_standing(const TradeoffPoint& point) {
    return point.is_on_front ? "front" : (point.is_surely_beaten ? "beaten" : "not surely beaten");
}

std::string make_time_cell(const TradeoffPoint& point) {
    return point.time.n == 0 ? "<td data-value=\"0\"><b>0</b><small>no passes</small></td>"
                             : make_estimate_cell(point.time);
}

std::string make_equal_time_cell(const Tradeoff& tradeoff, const TradeoffPoint& point) {
    if (!point.equal_time) {
        return kNothing;
    }
    const TradeoffPoint& other = tradeoff.points[*point.equal_time];
    return fmt::format("<td class=\"text\">{}<small>{} {}</small></td>",
                       make_breakable(other.label), escape_html(tradeoff.metric),
                       format_estimate(other.error).value);
}

std::string make_equal_error_cell(const Tradeoff& tradeoff, const TradeoffPoint& point) {
    if (!point.equal_error) {
        return kNothing;
    }
    const TradeoffPoint& other = tradeoff.points[*point.equal_error];
    const std::string time =
        point.time.value > 0.0 ? fmt::format("{} &times; this time",
                                             format_rounded(other.time.value / point.time.value))
                               : fmt::format("{} &times; anchor", format_rounded(other.time.value));
    return fmt::format("<td class=\"text\">{}<small>{}</small></td>", make_breakable(other.label),
                       time);
}

std::string make_quality_cell(const TimeToQuality& entry) {
    if (!entry.frames || !entry.time) {
        return "<td class=\"absent\">not reached</td>";
    }
    return fmt::format("<td data-value=\"{}\"><b>{}</b><small>{} &times; anchor</small></td>",
                       *entry.frames, *entry.frames, format_rounded(*entry.time));
}

std::string make_head(const Tradeoff& tradeoff) {
    std::string text = fmt::format(
        "<thead><tr><th class=\"name\">Method</th><th data-sort>Time<small>&times; "
        "anchor</small></th><th data-sort>{}<small>{}, {} is better</small></th><th "
        "class=\"text\">Standing</th><th class=\"text\">Best other<small>at no more "
        "time</small></th><th class=\"text\">Fastest other<small>at no more error</small></th>",
        escape_html(tradeoff.metric), to_text(tradeoff.state),
        tradeoff.lower_is_better ? "lower" : "higher");
    if (!tradeoff.to_quality.empty()) {
        for (const TimeToQuality& entry : tradeoff.to_quality.front()) {
            text += fmt::format("<th data-sort>Frames<small>to {} {}</small></th>",
                                tradeoff.lower_is_better ? "&le;" : "&ge;",
                                format_rounded(entry.bound));
        }
    }
    return text + "</tr></thead>\n";
}

std::string make_row(const Tradeoff& tradeoff, std::size_t index) {
    const TradeoffPoint& point = tradeoff.points[index];
    std::string text = fmt::format(
        "<tr><th scope=\"row\" class=\"name\">{}</th>{}{}<td class=\"text\">{}</td>{}{}",
        make_breakable(point.label), make_time_cell(point), make_estimate_cell(point.error),
        name_standing(point), make_equal_time_cell(tradeoff, point),
        make_equal_error_cell(tradeoff, point));
    if (!tradeoff.to_quality.empty()) {
        for (const TimeToQuality& entry : tradeoff.to_quality[index]) {
            text += make_quality_cell(entry);
        }
    }
    return text + "</tr>\n";
}

std::string make_table(const Tradeoff& tradeoff) {
    std::string text = fmt::format(
        "<details{} class=\"fold\"><summary>{} {}&times;{}, {}: {} cells</summary>\n"
        "<p class=\"note\">{}, {}, against {}{}.</p>\n"
        "<div class=\"scroll\"><table class=\"wide\" data-sortable>\n",
        tradeoff.points.size() <= kMostOpenRows ? " open" : "", escape_html(tradeoff.scene),
        tradeoff.width, tradeoff.height, escape_html(tradeoff.target), tradeoff.points.size(),
        escape_html(tradeoff.walkthrough), escape_html(tradeoff.precision),
        escape_html(tradeoff.reference),
        tradeoff.warm ? ", histories converged on the first pose of each burst" : "");
    text += make_head(tradeoff) + "<tbody>\n";
    for (std::size_t i = 0; i < tradeoff.points.size(); ++i) {
        text += make_row(tradeoff, i);
    }
    return text + "</tbody></table></div></details>\n";
}

} // namespace

std::string make_tradeoff_section(const RunAnalysis& analysis) {
    const std::vector<Tradeoff> tradeoffs = compute_tradeoffs(analysis);
    if (tradeoffs.empty()) {
        return {};
    }
    std::string text =
        "<section id=\"tradeoff\">\n<h2>Time against accuracy</h2>\n"
        "<p class=\"note\">All cells of a scene and target, from fast to slow; rounds are joined "
        "through the anchor. Times with their interval over repeats, errors with their interval "
        "over frames (over bursts where there are five or more): how far content spreads them, not "
        "how well they are known. <em>Front</em>: no other is better in both. <em>Beaten</em>: "
        "another is better in both and all intervals are apart. Others are cells of other methods "
        "that ran: nothing is interpolated. Frames: from an empty history until the error stays "
        "within the bound in every burst.</p>\n";
    for (const Tradeoff& tradeoff : tradeoffs) {
        text += make_table(tradeoff);
    }
    return text + "</section>\n";
}

} // namespace alcove
