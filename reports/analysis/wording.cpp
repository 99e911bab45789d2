#include "reports/analysis/wording.hpp"

#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace alcove {
namespace {

/// Decimals that show two significant digits of `width`, but no less than 3 and no more than 5
/// digits of `value`.
int choose_decimals(double value, double width) {
    const auto exponent = [](double x) { return static_cast<int>(std::floor(std::log10(x))); };
    const double magnitude = std::abs(value);
    const int leading = magnitude > 0.0 ? exponent(magnitude) : 0;
    const int from_width = width > 0.0 ? 1 - exponent(width) : 2 - leading;
    return std::clamp(from_width, std::max(0, 2 - leading), std::max(0, 4 - leading));
}

std::string list_front(const RoundAnalysis& round) {
    std::vector<const CellAnalysis*> front;
    for (const CellAnalysis& cell : round.cells) {
        if (cell.is_on_front && cell.ratio) {
            front.push_back(&cell);
        }
    }
    std::sort(front.begin(), front.end(), [](const CellAnalysis* a, const CellAnalysis* b) {
        return a->ratio->value < b->ratio->value;
    });
    std::string text;
    for (const CellAnalysis* cell : front) {
        const MetricAnalysis* error = cell->find(SampleState::cold, round.front_metric);
        text += fmt::format("{}{} ({}x the anchor, {} {})", text.empty() ? "" : "; ",
                            cell->cell.label, format_rounded(cell->ratio->value),
                            round.front_metric, format_error(*error));
    }
    return text;
}

std::string format_scaled(const MetricAnalysis& error, double scale) {
    if (error.is_below_floor) {
        return (error.shown() < *error.floor ? "< " : "> ") + format_rounded(scale * *error.floor);
    }
    return format_rounded(scale * error.shown());
}

} // namespace

EstimateText format_estimate(const Estimate& estimate) {
    const double lower = estimate.interval ? estimate.interval->lower : estimate.minimum;
    const double upper = estimate.interval ? estimate.interval->upper : estimate.maximum;
    const int decimals = choose_decimals(estimate.value, 0.5 * (upper - lower));
    const auto format = [&](double value) { return fmt::format("{:.{}f}", value, decimals); };
    return {format(estimate.value),
            estimate.interval
                ? fmt::format("[{}, {}] (n={})", format(lower), format(upper), estimate.n)
                : fmt::format("{}..{} (n={})", format(lower), format(upper), estimate.n)};
}

std::string describe_estimate(const Estimate& estimate) {
    const EstimateText text = format_estimate(estimate);
    return text.value + " " + text.spread;
}

std::string format_error(const MetricAnalysis& error) {
    return format_scaled(error, 1.0);
}

std::string format_codes(const MetricAnalysis& error) {
    return format_scaled(error, 255.0);
}

std::string count_rounds(std::size_t rounds) {
    return fmt::format("{} round{}", rounds, rounds == 1 ? "" : "s");
}

std::string format_percent(double fraction) {
    return format_rounded(100.0 * fraction, 2) + " %";
}

std::string describe_device(const ContextRecord& context) {
    return fmt::format("{}: {}, {} threads, {}", context.device_class, context.gl_renderer,
                       context.driver_threads, context.context_kind);
}

std::string describe_timer(const RunAnalysis& analysis) {
    const ContextRecord& context = analysis.context;
    return fmt::format("{} ({}), tick {} ns", context.timer_mode,
                       analysis.is_timer_validated
                           ? "validated in this context"
                           : "fenced by glFinish, no timer query was accepted",
                       format_rounded(context.timer_tick_ns));
}

std::string describe_noise(const RoundAnalysis& round) {
    if (!round.aa_ratio) {
        return "noise unknown: the anchor was not timed twice";
    }
    return fmt::format("A/A {}: time differences under {} are not told from noise",
                       describe_estimate(*round.aa_ratio),
                       format_percent(*round.minimum_detectable_effect));
}

std::string describe_repeats(const RunAnalysis& analysis, const RoundAnalysis& round) {
    const RepeatsRecord& repeats = round.done.repeats;
    if (repeats.reason == StopReason::planned) {
        return {};
    }
    std::string text = fmt::format("{} repeats: ", repeats.taken);
    if (repeats.reason == StopReason::time) {
        text += fmt::format("the time limit of {} s was up; ",
                            format_rounded(analysis.plan.time_limit_s));
    } else if (repeats.reason == StopReason::most) {
        text += "no more are allowed; ";
    }
    const auto cell =
        std::find_if(round.cells.begin(), round.cells.end(), [&](const CellAnalysis& other) {
            return other.cell.id == repeats.widest_cell;
        });
    text += repeats.widest
                ? fmt::format("the widest interval is +-{} ({})", format_percent(*repeats.widest),
                              cell == round.cells.end() ? repeats.widest_cell : cell->cell.label)
                : "too few for intervals";
    return text + fmt::format(", asked for +-{}", format_percent(analysis.plan.until_width));
}

std::string describe_outliers(const RoundAnalysis& round) {
    std::string text;
    for (const CellAnalysis& cell : round.cells) {
        if (!cell.outliers || !cell.outliers->any()) {
            continue;
        }
        text +=
            fmt::format("{} {}", text.empty() ? "outlying repeats, kept:" : ",", cell.cell.label);
        if (cell.outliers->severe > 0) {
            text += fmt::format(" {} severe", cell.outliers->severe);
        }
        if (cell.outliers->mild > 0) {
            text += fmt::format(" {} mild", cell.outliers->mild);
        }
        text += fmt::format(" of {}", cell.outliers->n);
    }
    return text;
}

std::string describe_floor(const RoundAnalysis& round) {
    if (!round.reference_floor) {
        return "no reference floor";
    }
    std::string text = fmt::format("reference floor {} {}", format_rounded(*round.reference_floor),
                                   round.front_metric);
    if (round.smallest_error && *round.smallest_error > *round.reference_floor) {
        text += fmt::format(", {} of the smallest error",
                            format_percent(*round.reference_floor / *round.smallest_error));
    } else if (round.smallest_error) {
        text += ", above the smallest error: more reference rays are needed to rank it";
    }
    return text;
}

std::string describe_effects(const RoundAnalysis& round) {
    if (round.round.effects.empty()) {
        return {};
    }
    std::string text = "Effects:";
    for (const EffectRecord& effect : round.round.effects) {
        text += fmt::format("{} {} {} ({})", text.ends_with(':') ? "" : ";", effect.effect,
                            effect.is_needed ? "kept" : "left out", effect.evidence);
    }
    text += ".";
    for (const SavingRecord& saving : round.done.savings) {
        const auto cell = std::find_if(
            round.cells.begin(), round.cells.end(),
            [&saving](const CellAnalysis& other) { return other.cell.id == saving.cell; });
        text +=
            fmt::format(" {}: {:.3f} [{:.3f}, {:.3f}] (n={}) of the time with all effects, "
                        "images within {:.2f}/255.",
                        cell == round.cells.end() ? saving.cell : cell->cell.label, saving.ratio,
                        saving.lower, saving.upper, saving.n, 255.0 * saving.largest_difference);
    }
    return text;
}

std::string describe_verdict(const RoundAnalysis& round) {
    const std::string front = list_front(round);
    if (std::none_of(round.cells.begin(), round.cells.end(), is_compared)) {
        return "Nothing is compared here: native settings, or no method.";
    }
    if (front.empty()) {
        return "No method has both a time and an error here.";
    }
    return "Not beaten in both time and error: " + front + ".";
}

} // namespace alcove
