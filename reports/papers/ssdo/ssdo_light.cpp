#include "reports/analysis/wording.hpp"
#include "reports/papers/ssdo/ssdo_parts.hpp"

#include <algorithm>
#include <vector>

#include <fmt/core.h>

namespace alcove {
namespace {

constexpr auto kCold = SampleState::cold;
const char* const kFloorColour = "chroma_error[floor]";
/// Of CIELAB's a and b, on the mean: a fiftieth of what is just seen side by side (2.3).
constexpr double kGrey = 0.05;

void judge_figure3(const Evidence& evidence, Judge& judge) {
    const Estimate shadows =
        compare_values(evidence, "fig3_chroma", 0, "SSDO", "SSAO", kFloorColour);
    const Estimate bounce = compare_values(evidence, "fig3", 0, "bounce", "SSDO", kFloorColour);
    const Estimate near_yellow =
        compare_values(evidence, "fig3", 0, "bounce", "SSDO", "chroma_error[yellow]");
    // Surroundings of two sides light a floor in one colour, from which shadows may differ.
    const Estimate ambient = estimate_value(evidence, "turning_light", 0, "SSAO", kFloorColour);
    const Estimate directional = estimate_value(evidence, "turning_light", 0, "SSDO", kFloorColour);
    judge.set(
        "SSDO-043",
        {combine({judge_below(ambient, kGrey), judge_above(directional, 10.0 * kGrey),
                  judge_below(shadows, 0.0), judge_below(bounce, 0.0)}),
         fmt::format("SSAO leaves the floor its colour (chroma_error to the floor without "
                     "occlusion below {}), SSDO does not (above {}) and comes nearer to "
                     "path-traced light without a bounce; with a bounce nearer than without to "
                     "path-traced light with one",
                     kGrey, 10.0 * kGrey),
         directional,
         fmt::format("{}; measured: SSDO's chroma_error to the floor without occlusion; SSAO's {}. "
                     "To path-traced light, SSDO - SSAO {}; with a bounce - without {}, on the "
                     "yellow block {}",
                     describe_round(evidence, "fig3"), describe_estimate(ambient),
                     describe_estimate(shadows), describe_estimate(bounce),
                     describe_estimate(near_yellow))});
}

/// What a bounce changes of the floor's colour, frame by frame.
std::vector<double> get_yellow(const Evidence& evidence, const char* label) {
    return evidence.get_values({"fig4", 0, label}, kFloorColour, kCold);
}

void judge_figure4(const Evidence& evidence, Judge& judge) {
    const std::vector<double> yellow = get_yellow(evidence, "bounce");
    const double first = yellow.front();
    const double last = yellow.at(kFig4Seen - 1);
    std::vector<double> steps;
    for (std::size_t i = 0; i + 1 < kFig4Seen; ++i) {
        steps.push_back(yellow[i] - yellow[i + 1]);
    }
    const double mean = (first - last) / static_cast<double>(steps.size());
    const double least = *std::min_element(steps.begin(), steps.end());
    const double most = *std::max_element(steps.begin(), steps.end());
    const std::vector<double> traced =
        evidence.get_values({"fig4_traced", 0, "traced"}, kFloorColour, kCold);
    const std::vector<double> cameras = get_yellow(evidence, "four cameras");
    const Estimate gone = make_single(last / first);
    judge.set(
        "SSDO-044",
        {combine({least > 0.0 ? Outcome::holds : Outcome::fails,
                  most < 3.0 * mean ? Outcome::holds : Outcome::fails, judge_below(gone, 0.5)}),
         "while the yellow side turns away, what a bounce changes of the floor's colour falls "
         "in every step of five frames, by less than three times the mean step, to less than "
         "half",
         gone,
         fmt::format("{}; measured: last / first, of chroma_error between SSDO with and "
                     "without a bounce. Steps from {:.4f} to {:.4f}, mean {:.4f}. The light "
                     "path traced goes from {:.3f} to {:.3f}, with four further cameras from "
                     "{:.3f} to {:.3f}: the rest is the bias that the paper names",
                     describe_round(evidence, "fig4"), least, most, mean, traced.front(),
                     traced.back(), cameras.front(), cameras.back())});
    judge.set("SSDO-042",
              {judge_below(gone, 0.5),
               "a sender whose side is seen sends, and turned away it does not: the floor's yellow "
               "falls to less than half",
               gone,
               "as SSDO-044; of the four samples of the figure a run shows only the senders' "
               "sides"});
}

void judge_constant(const Evidence& evidence, Judge& judge) {
    const Estimate constant = estimate_value(evidence, "identity", 0, "SSDO", "max_error");
    const Estimate coloured = estimate_value(evidence, "identity", 1, "SSDO", "max_error");
    judge.set("SSDO-074",
              {combine({judge_below(constant, 0.001), judge_above(coloured, 0.01)}),
               "in constant light no pixel differs by 0.001 from cosine-weighted ambient occlusion "
               "of the same samples; in light of two colours some do by 0.01",
               constant,
               fmt::format("{}; in two colours {}; constant light without occlusion {}",
                           describe_round(evidence, "identity"), describe_estimate(coloured),
                           describe_estimate(
                               estimate_value(evidence, "identity", 0, "nothing", "max_error")))});
}

/// Largest - smallest value of a series over its mean.
double get_spread(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return (*high - *low) * static_cast<double>(values.size()) / sum;
}

void judge_turning(const Evidence& evidence, Judge& judge) {
    const auto get = [&](const char* label) {
        return make_single(
            get_spread(evidence.get_values({"turning_light", 0, label}, "rmse[floor]", kCold)));
    };
    const Estimate ambient = get("SSAO");
    const Estimate directional = get("SSDO");
    judge.set(
        "SSDO-082",
        {combine({judge_below(ambient, 0.002), judge_above(directional, 0.02)}),
         "while the surroundings turn, what SSAO takes from the floor's light stays as it is "
         "(largest - smallest over the mean below 0.002), and what SSDO takes changes (above "
         "0.02)",
         directional,
         fmt::format("{}, a quarter turn each second; the floor's own light does not change as "
                     "the surroundings turn; measured: SSDO. SSAO {:.6f}",
                     describe_round(evidence, "turning_light"), ambient.value)});
}

void judge_bandwidth(const Evidence& evidence, Judge& judge) {
    const auto at = [](std::size_t round, const char* label) {
        return CellAddress{"bandwidth", round, label};
    };
    const auto rise = [&](std::size_t a, std::size_t b) {
        return evidence.compare_metric(at(a, "16 samples"), at(b, "16 samples"), "rmse", kCold);
    };
    const Estimate more =
        evidence.compare_metric(at(2, "64 samples"), at(2, "16 samples"), "rmse", kCold);
    judge.set("SSDO-089",
              {combine({judge_above(rise(1, 0), 0.0), judge_above(rise(2, 1), 0.0),
                        judge_below(more, 0.0)}),
               "rmse of 16 samples to 256, neither blurred, rises from constant light to a sky and "
               "to a pattern of fields, and falls there with 64 samples",
               rise(2, 1),
               fmt::format("{}; measured: pattern - sky. Sky - constant {}; 64 samples - 16 {}",
                           describe_round(evidence, "bandwidth"), describe_estimate(rise(1, 0)),
                           describe_estimate(more))});
}

} // namespace

void judge_ssdo_light(const Evidence& evidence, Judge& judge) {
    judge_figure3(evidence, judge);
    judge_figure4(evidence, judge);
    judge_constant(evidence, judge);
    judge_turning(evidence, judge);
    judge_bandwidth(evidence, judge);
}

} // namespace alcove
