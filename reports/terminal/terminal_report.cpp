#include "reports/terminal/terminal_report.hpp"

#include "reports/analysis/wording.hpp"
#include "reports/terminal/text_table.hpp"
#include "reports/terminal/time_table.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace alcove {
namespace {

std::string format_optional(const std::optional<Estimate>& estimate) {
    return estimate ? describe_estimate(*estimate) : "-";
}

std::string format_metric(const CellAnalysis& cell, SampleState state, const std::string& metric) {
    const MetricAnalysis* error = cell.find(state, metric);
    return error == nullptr ? "-" : fmt::format("{} (n={})", format_error(*error), error->frames);
}

std::vector<std::string> make_line(const CellAnalysis& cell,
                                   const std::vector<std::string>& metrics) {
    std::vector<std::string> line = {cell.is_on_front ? "*" : "", clean_text(cell.cell.label)};
    if (cell.cell.has_passes) {
        line.push_back(cell.cell.role == CellRole::anchor ? "1 (the unit)"
                                                          : format_optional(cell.ratio));
        line.push_back(format_optional(cell.time_ms));
    } else {
        line.insert(line.end(), {"-", "0 (no passes)"});
    }
    line.push_back(format_optional(cell.total_ms));
    for (const std::string& metric : metrics) {
        line.push_back(format_metric(cell, SampleState::cold, metric));
        line.push_back(format_metric(cell, SampleState::converged, metric));
    }
    return line;
}

/// The error that the front is drawn with, and ssim beside it.
std::vector<std::string> choose_metrics(const RoundAnalysis& round) {
    std::vector<std::string> metrics;
    for (const std::string& metric : round.metrics) {
        if (metric == round.front_metric || metric == "ssim") {
            metrics.push_back(metric);
        }
    }
    return metrics;
}

std::string describe_round(const RunAnalysis& analysis, const RoundAnalysis& round) {
    const std::string unit = " [ms " + analysis.context.device_class + "]";
    const std::vector<std::string> metrics = choose_metrics(round);
    TextLines lines = {{"", "method", "x anchor", "AO" + unit, "frame" + unit}};
    for (const std::string& metric : metrics) {
        lines[0].push_back(metric + " cold");
        lines[0].push_back(metric + " converged");
    }
    for (const CellAnalysis& cell : round.cells) {
        lines.push_back(make_line(cell, metrics));
    }
    const std::string effects = describe_effects(round);
    std::string conditions = "  " + clean_text(describe_fitness(round.machine)) + "\n";
    for (const std::string& line : {describe_repeats(analysis, round), describe_outliers(round)}) {
        conditions += line.empty() ? "" : "  " + clean_text(line) + "\n";
    }
    return fmt::format("{} {}x{}, {}, errors of {} against {}\n{}{}  {}\n  {}; {}\n{}{}\n",
                       clean_text(round.round.scene), round.round.width, round.round.height,
                       clean_text(round.round.target),
                       measures_pictures(round.round) ? "pictures" : "visibility",
                       clean_text(round.round.reference.label), align_columns(lines),
                       effects.empty() ? "" : "  " + clean_text(effects) + "\n",
                       clean_text(describe_verdict(round)), clean_text(describe_noise(round)),
                       clean_text(describe_floor(round)), conditions, make_time_table(round));
}

} // namespace

std::string make_terminal_report(const RunAnalysis& analysis, const std::filesystem::path& page) {
    std::string text;
    for (const RoundAnalysis& round : analysis.rounds) {
        text += describe_round(analysis, round);
    }
    for (const ProvisionalRow& row : analysis.provisional) {
        text += fmt::format("provisional: {} {:.3f} ms {} (n=1)\n", clean_text(row.label),
                            row.time_ms, analysis.context.device_class);
    }
    for (const SkippedRecord& skipped : analysis.plan.skipped) {
        text +=
            fmt::format("skipped: {}: {}\n", clean_text(skipped.what), clean_text(skipped.reason));
    }
    if (!analysis.is_complete) {
        text += fmt::format("in progress: {} of {} finished\n", analysis.rounds.size(),
                            count_rounds(analysis.plan.rounds.size()));
    }
    text +=
        "Times: [95 % interval] or min..max over n repeats. Errors: mean over n frames, `<` their "
        "floor where the reference's own noise is larger.\n* not beaten in both time and error\n";
    text += fmt::format("{}; timer {}\n", clean_text(describe_device(analysis.context)),
                        clean_text(describe_timer(analysis)));
    text += "report: " + page.string() + "\n";
    return text;
}

} // namespace alcove
