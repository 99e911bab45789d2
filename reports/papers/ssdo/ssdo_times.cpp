#include "core/base/text.hpp"
#include "reports/analysis/series.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/papers/ssdo/ssdo_parts.hpp"

#include <fmt/core.h>

namespace alcove {
namespace {

/// Largest published losses of frames a second, in percent: what "small" and "moderate" mean.
constexpr double kSmallLoss = 8.9;
constexpr double kModerateLoss = 46.4;
constexpr std::size_t kSmallest = 0;
constexpr std::size_t kLargest = 3;

std::string make_id(int number) {
    return fmt::format("SSDO-{:03}", number);
}

std::string describe_cell(const Evidence& evidence, std::size_t round) {
    return describe_round(evidence, "table1", round);
}

/// By repeat, what `what` loses of SSAO's frames a second, in percent.
std::map<int, double> get_losses(const Evidence& evidence, std::size_t round, const char* what,
                                 int samples) {
    return combine_repeats(evidence.get_frame_ms(find_table1_cell(round, "SSAO", samples)),
                           evidence.get_frame_ms(find_table1_cell(round, what, samples)),
                           [](double ssao, double other) { return 100.0 * (1.0 - ssao / other); });
}

/// Two series joined repeat by repeat; those of two rounds are paired by the repeat's number.
Estimate estimate_pairs(const std::map<int, double>& a, const std::map<int, double>& b,
                        double (*join)(double, double)) {
    std::vector<double> values;
    for (const auto& [repeat, value] : combine_repeats(a, b, join)) {
        values.push_back(value);
    }
    return estimate_across_repeats(values);
}

double subtract(double a, double b) {
    return a - b;
}

double divide(double a, double b) {
    return a / b;
}

/// Is a bounce's frame slower than the same without?
Outcome judge_bounce(const Evidence& evidence, std::size_t round, int samples) {
    return judge_above(evidence.compare_frames(find_table1_cell(round, "bounce", samples),
                                               find_table1_cell(round, "SSDO", samples)),
                       1.0);
}

/// Frames of `what` at 16 samples / at 8, in frames a second.
Estimate compare_samples(const Evidence& evidence, std::size_t round, const char* what) {
    return evidence.compare_frames(find_table1_cell(round, what, 8),
                                   find_table1_cell(round, what, 16));
}

/// Time of the passes at 16 samples / at 8.
Estimate compare_pass_samples(const Evidence& evidence, std::size_t round, const char* what) {
    return evidence.compare_costs(find_table1_cell(round, what, 16),
                                  find_table1_cell(round, what, 8));
}

void judge_row(const Evidence& evidence, const SsdoRow& row, Judge& judge) {
    const std::string on = describe_cell(evidence, row.round);
    const std::string misprint =
        *row.misprint == '\0' ? std::string() : std::string("; ") + row.misprint;
    const Estimate slower = compare_samples(evidence, row.round, "SSAO");
    judge.set(make_id(row.first_claim),
              {judge_below(slower, 1.0), "frames a second of SSAO at 16 samples / at 8 below 1",
               slower, on + misprint});

    const Estimate direct = estimate_frame_loss(evidence, row.round, "SSDO", row.samples);
    const Estimate direct_passes = estimate_pass_loss(evidence, row.round, "SSDO", row.samples);
    const Finding small{
        judge_below(direct, kSmallLoss),
        fmt::format("SSDO loses less than {} % of SSAO's frames a second, the largest loss in "
                    "print",
                    kSmallLoss),
        direct,
        fmt::format("{}; in print {} %{}; of passes alone {} %", on,
                    format_rounded(row.ssdo_loss, 3), misprint, describe_estimate(direct_passes))};
    judge.set(make_id(row.first_claim + 1), small);
    judge.set(make_id(row.first_claim + 2), small);

    const Estimate bounce = estimate_frame_loss(evidence, row.round, "bounce", row.samples);
    const Estimate bounce_passes = estimate_pass_loss(evidence, row.round, "bounce", row.samples);
    const Finding moderate{
        combine(
            {judge_bounce(evidence, row.round, row.samples), judge_below(bounce, kModerateLoss)}),
        fmt::format("a bounce loses more frames a second than SSDO without, and less than {} % of "
                    "SSAO's, the largest loss in print",
                    kModerateLoss),
        bounce,
        fmt::format("{}; in print {} %{}; of passes alone {} %", on,
                    format_rounded(row.bounce_loss, 3), misprint,
                    describe_estimate(bounce_passes))};
    judge.set(make_id(row.first_claim + 3), moderate);
    judge.set(make_id(row.first_claim + 4), moderate);
}

/// Growth of a's passes from 8 to 16 samples over that of b's.
Estimate compare_growth(const Evidence& evidence, std::size_t round, const char* a, const char* b) {
    const auto get = [&](const char* what) {
        return combine_repeats(evidence.get_cost_ms(find_table1_cell(round, what, 16)),
                               evidence.get_cost_ms(find_table1_cell(round, what, 8)), divide);
    };
    return estimate_pairs(get(a), get(b), divide);
}

/// Passes of `what` grow by more than those of `other` from 8 samples to 16, at every size.
Finding judge_growth(const Evidence& evidence, const char* what, const char* other) {
    std::vector<Outcome> outcomes;
    for (std::size_t round = 0; round < list_ssdo_sizes().size(); ++round) {
        outcomes.push_back(judge_above(compare_growth(evidence, round, what, other), 1.0));
    }
    return {combine(outcomes),
            fmt::format("passes of {} grow by more than those of {} from 8 to 16 samples, at every "
                        "size",
                        what, other),
            compare_pass_samples(evidence, kLargest, what),
            fmt::format("{}; measured: passes of {} at 16 / at 8; of {} {}; frames a second {}",
                        describe_cell(evidence, kLargest), what, other,
                        describe_estimate(compare_pass_samples(evidence, kLargest, other)),
                        describe_estimate(compare_samples(evidence, kLargest, what)))};
}

void judge_samples(const Evidence& evidence, Judge& judge) {
    std::vector<Outcome> slower;
    for (std::size_t round = 0; round < list_ssdo_sizes().size(); ++round) {
        slower.push_back(judge_within(compare_pass_samples(evidence, round, "SSAO"), 1.2, 2.2));
    }
    judge.set(
        "SSDO-033",
        {combine(slower), "passes of SSAO at 16 samples / at 8 between 1.2 and 2.2, at every size",
         compare_pass_samples(evidence, kLargest, "SSAO"),
         fmt::format("{}; frames a second {}; in print 0.677", describe_cell(evidence, kLargest),
                     describe_estimate(compare_samples(evidence, kLargest, "SSAO")))});
    judge.set("SSDO-034", judge_growth(evidence, "SSDO", "SSAO"));
    judge.set("SSDO-035", judge_growth(evidence, "bounce", "SSDO"));

    std::vector<Outcome> with_samples;
    std::vector<Outcome> with_size;
    std::string sizes;
    for (const char* what : {"SSDO", "bounce"}) {
        for (std::size_t round = 0; round < list_ssdo_sizes().size(); ++round) {
            with_samples.push_back(
                judge_above(estimate_pairs(get_losses(evidence, round, what, 16),
                                           get_losses(evidence, round, what, 8), subtract),
                            0.0));
        }
        for (const int samples : {8, 16}) {
            const auto get = [&](std::size_t round) {
                return estimate_frame_loss(evidence, round, what, samples);
            };
            for (const auto& [larger, smaller] : {std::pair{1, 0}, std::pair{3, 1}}) {
                with_size.push_back(judge_above(
                    estimate_pairs(get_losses(evidence, larger, what, samples),
                                   get_losses(evidence, smaller, what, samples), subtract),
                    0.0));
            }
            sizes += fmt::format("; {} {}: {}, {}, {}", what, samples, describe_estimate(get(0)),
                                 describe_estimate(get(1)), describe_estimate(get(3)));
        }
    }
    judge.set("SSDO-036",
              {combine(with_samples),
               "losses of frames a second are larger at 16 samples than at 8, at every size, with "
               "and without a bounce",
               estimate_frame_loss(evidence, kLargest, "bounce", 16),
               describe_cell(evidence, kLargest) + "; measured: with a bounce, percent; at 8 " +
                   describe_estimate(estimate_frame_loss(evidence, kLargest, "bounce", 8))});
    judge.set("SSDO-037",
              {combine(with_size),
               "losses of frames a second rise from 1024x768 to 1200x960 and 1600x1200, or what "
               "stands for them, at 8 and 16 samples, with and without a bounce",
               estimate_frame_loss(evidence, kLargest, "bounce", 16),
               "measured: with a bounce, 16 samples, at the largest, percent" + sizes});
}

/// Cost a pixel of SSAO with 8 samples in a round over that in another.
Estimate compare_cost_a_pixel(const Evidence& evidence, std::size_t a, std::size_t b) {
    const RoundRecord& of_a = evidence.get_round("table1", a);
    const RoundRecord& of_b = evidence.get_round("table1", b);
    const double pixels = static_cast<double>(of_b.width) * of_b.height /
                          (static_cast<double>(of_a.width) * of_a.height);
    return scale_estimate(
        evidence.compare_costs(find_table1_cell(a, "SSAO", 8), find_table1_cell(b, "SSAO", 8)),
        pixels);
}

void judge_sizes(const Evidence& evidence, Judge& judge) {
    std::vector<Outcome> outcomes;
    for (std::size_t round = 1; round < list_ssdo_sizes().size(); ++round) {
        outcomes.push_back(
            judge_within(compare_cost_a_pixel(evidence, round, kSmallest), 0.8, 1.25));
    }
    judge.set(
        "SSDO-038",
        {combine(outcomes), "passes of SSAO cost as much a pixel at every size, within a quarter",
         compare_cost_a_pixel(evidence, kLargest, kSmallest),
         fmt::format("measured: largest / smallest; 1200x960 {}, 1280x960 {}. In print frames "
                     "of the second size take 2.149 times those of the first for 1.465 times "
                     "the pixels, and those of the third 1.520 times for 1.667: of 1280x960 "
                     "it would be 1.563 twice, which is nearer on both sides, and not "
                     "near",
                     describe_estimate(compare_cost_a_pixel(evidence, 1, kSmallest)),
                     describe_estimate(compare_cost_a_pixel(evidence, 2, kSmallest)))});
    const Estimate empty = evidence.compare_frames({"table1", kLargest, "nothing"},
                                                   find_table1_cell(kLargest, "SSAO", 8));
    judge.set("SSDO-031",
              {judge_below(empty, 1.0),
               "frame without occlusion / frame with SSAO of 8 samples below 1", empty,
               describe_cell(evidence, kLargest) +
                   "; in print 24.8 / 124 = 0.2: ours draws the scene's triangles more slowly "
                   "beside its passes, so that losses of whole frames are smaller"});
}

/// Mean over the six cells of a column of table 1, repeat by repeat.
Estimate average_losses(const Evidence& evidence, const char* what) {
    std::map<int, double> sum;
    const auto add = [](double x, double y) { return x + y; };
    for (const SsdoRow& row : list_ssdo_rows()) {
        const std::map<int, double> losses = get_losses(evidence, row.round, what, row.samples);
        sum = sum.empty() ? losses : combine_repeats(sum, losses, add);
    }
    std::vector<double> means;
    for (const auto& [repeat, losses] : sum) {
        means.push_back(losses / static_cast<double>(list_ssdo_rows().size()));
    }
    return estimate_across_repeats(means);
}

void judge_averages(const Evidence& evidence, Judge& judge) {
    const Estimate direct = average_losses(evidence, "SSDO");
    const Estimate bounce = average_losses(evidence, "bounce");
    judge.set("SSDO-039", {judge_below(direct, kSmallLoss),
                           fmt::format("mean loss of SSDO below {} %", kSmallLoss), direct,
                           "six cells of table 1; 3.6 % in print"});
    judge.set(
        "SSDO-040",
        {combine({judge_above(bounce, direct.value), judge_below(bounce, kModerateLoss)}),
         fmt::format("mean loss with a bounce above that without, and below {} %", kModerateLoss),
         bounce,
         "six cells of table 1; 31.1 % in print, 34.4 % with the misprint mended; without a "
         "bounce " +
             describe_estimate(direct)});
}

/// Passes of a cell in the round of many triangles over those in the round of few, each in units
/// of its round's anchor: what drifts from round to round falls on both.
Estimate compare_polygons(const Evidence& evidence, const char* label,
                          const std::vector<std::string>& passes) {
    const auto get = [&](std::size_t round) {
        return combine_repeats(evidence.get_passes_ms({"polygons", round, label}, passes),
                               evidence.get_cost_ms({"polygons", round, "anchor"}), divide);
    };
    return estimate_pairs(get(1), get(0), divide);
}

void judge_polygons(const Evidence& evidence, Judge& judge) {
    const Estimate direct = compare_polygons(evidence, "direct", {"ssdo/direct"});
    const Estimate bounce = compare_polygons(evidence, "bounce", {"ssdo/direct", "ssdo/bounce"});
    judge.set("SSDO-079",
              {combine({judge_within(direct, 0.75, 1.33), judge_within(bounce, 0.75, 1.33)}),
               "times of direct and bounced light at 537,344 triangles / at 35,044 within a third "
               "of 1",
               bounce,
               fmt::format("{}; measured: passes with a bounce; without {}",
                           describe_round(evidence, "polygons"), describe_estimate(direct))});
}

} // namespace

void judge_ssdo_times(const Evidence& evidence, Judge& judge) {
    for (const SsdoRow& row : list_ssdo_rows()) {
        judge_row(evidence, row, judge);
    }
    judge_samples(evidence, judge);
    judge_sizes(evidence, judge);
    judge_averages(evidence, judge);
    judge_polygons(evidence, judge);
}

} // namespace alcove
