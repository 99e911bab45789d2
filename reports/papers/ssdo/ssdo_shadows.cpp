#include "reports/analysis/wording.hpp"
#include "reports/papers/ssdo/ssdo_parts.hpp"

#include <fmt/core.h>

namespace alcove {
namespace {

/// 1 + half and twice of what a ratio in print is above 1.
Outcome judge_alike(const Estimate& ratio, double printed) {
    return judge_within(ratio, 1.0 + 0.5 * (printed - 1.0), 1.0 + 2.0 * (printed - 1.0));
}

void judge_figure6(const Evidence& evidence, Judge& judge) {
    const std::string on = describe_round(evidence, "fig6");
    const char* const kFalse = "false_occlusion:least=0.05";
    const auto differ = [&](const char* a, const char* b, const char* metric) {
        return compare_values(evidence, "fig6", 0, a, b, metric);
    };
    const Estimate one = differ("1 layer, 1 m", "1 layer, 0.25 m", kFalse);
    const Estimate mended = differ("2 layers, 1 m", "1 layer, 1 m", kFalse);
    const Estimate nearer = differ("2 layers, 1 m", "2 layers, 0.25 m", "rmse");
    judge.set(
        "SSDO-046",
        {combine({judge_above(one, 0.0), judge_below(mended, 0.0), judge_below(nearer, 0.0)}),
         "false shadow grows with r_max from 0.25 to 1 m with one layer and is less with two, "
         "whose rmse to a fine shadow map falls as r_max reaches the blocker",
         one,
         fmt::format(
             "{}; measured: share of pixels, one layer, 1 m - 0.25 m. Two layers - "
             "one at 1 m {}; rmse of two layers, 1 m - 0.25 m {}, at 1 m {}",
             on, describe_estimate(mended), describe_estimate(nearer),
             describe_estimate(estimate_value(evidence, "fig6", 0, "2 layers, 1 m", "rmse")))});
    const Estimate frame =
        evidence.compare_frames({"fig6", 0, "2 layers, 0.5 m"}, {"fig6", 0, "1 layer, 0.5 m"});
    judge.set("SSDO-047",
              {judge_alike(frame, 1.3),
               "frame with two layers / with one between 1.15 and 1.6: half and twice of 30 % more",
               frame, on});
}

void judge_figure9(const Evidence& evidence, Judge& judge) {
    const std::string on = describe_round(evidence, "fig9");
    const char* const kSingle = "corrected, 16 samples";
    const char* const kPeeled = "corrected, 2 layers, 8 samples";
    const auto compare = [&](const char* a, const char* b) {
        return evidence.compare_frames({"fig9", 0, a}, {"fig9", 0, b});
    };
    const Estimate single = compare(kSingle, "bias");
    const Estimate peeled = compare(kPeeled, "bias");
    const Estimate order = compare(kPeeled, kSingle);
    judge.set("SSDO-056", {combine({judge_above(single, 1.0), judge_above(peeled, 1.0)}),
                           "the frame of the classic bias is faster than both corrections", single,
                           on + "; measured: one layer / bias"});
    judge.set("SSDO-057", {judge_alike(single, 2.12),
                           "frame with one layer and 16 samples / of the classic bias between 1.56 "
                           "and 3.24: half and twice of what is printed above 1",
                           single, on + "; 2.12 in print"});
    judge.set(
        "SSDO-058",
        {combine({judge_alike(peeled, 2.99), judge_above(order, 1.0)}),
         "frame with two layers and 8 samples / of the classic bias between 2.0 and 4.98, and "
         "slower than one layer with 16",
         peeled,
         fmt::format("{}; 2.99 in print; two layers / one {}", on, describe_estimate(order))});
    std::vector<Finding> findings;
    std::string all;
    for (const char* corrected : {kPeeled, kSingle}) {
        for (const char* control : {"bias", "no bias"}) {
            const Estimate difference =
                compare_values(evidence, "fig9", 0, corrected, control, "rmse");
            findings.push_back({judge_below(difference, 0.0),
                                fmt::format("rmse {} - {} < 0", corrected, control), difference,
                                on});
            all += fmt::format("; {} - {} {}", corrected, control, describe_estimate(difference));
        }
    }
    Finding finding =
        combine_findings(findings, "rmse to a fine map is lower with both corrections than with "
                                   "the bias alone and without bias");
    const auto dark = [&](const char* label) {
        return describe_estimate(
            estimate_value(evidence, "fig9", 0, label, "false_occlusion:least=0.05"));
    };
    finding.why += fmt::format("{}; false shadows: no bias {}, bias {}, one layer {}, two {}", all,
                               dark("no bias"), dark("bias"), dark(kSingle), dark(kPeeled));
    judge.set("SSDO-059", finding);
}

void judge_virtual_lights(const Evidence& evidence, Judge& judge) {
    const Estimate natural = compare_values(evidence, "fig10", 0, "corrected", "bias", "rmse");
    const Estimate frame = evidence.compare_frames({"fig10", 0, "corrected"}, {"fig10", 0, "bias"});
    const std::string on = describe_round(evidence, "fig10") +
                           ", 32 lights with maps of 128 texels, which stand for 256 of 512";
    judge.set("SSDO-060", {judge_above(frame, 1.0),
                           "the frame of the bias alone is faster than the corrected", frame, on});
    judge.set("SSDO-061",
              {judge_alike(frame, 2.14),
               "frame corrected by 8 samples a map / with the bias alone between 1.57 and 3.28: "
               "half and twice of what is printed above 1",
               frame,
               fmt::format("{}; 2.14 in print; rmse to path tracing, corrected - bias {}", on,
                           describe_estimate(natural))});
    const CellAddress corrected{"fig10", 0, "corrected"};
    const std::string samples = evidence.find_parameter(corrected, "correction_samples");
    judge.set("SSDO-064", {samples == "8" ? Outcome::holds : Outcome::fails,
                           "8 samples a shadow map correct it", std::nullopt, on});
    const auto missing = [](const char* part) { return CellAddress{part, 0, "fine maps"}; };
    const Estimate toes = evidence.compare_metric(missing("fig11_corrected"), missing("fig11_bias"),
                                                  "false_occlusion:least=0.05", SampleState::cold);
    judge.set(
        "SSDO-065",
        {judge_below(toes, 0.0),
         "near toes the share of pixels where fine maps are darker by 0.05 falls with the "
         "correction",
         toes,
         fmt::format(
             "{}, 32 virtual lights with maps of 64 texels; measured: corrected - "
             "bias. The mean difference to fine maps, both ways, is {} corrected and {} with the "
             "bias alone; fine maps miss shadows too, and methods_instant_radiosity_test holds "
             "both against shadow rays",
             describe_round(evidence, "fig11_bias"),
             describe_estimate(estimate_value(evidence, "fig11_corrected", 0, "fine maps", "mae")),
             describe_estimate(estimate_value(evidence, "fig11_bias", 0, "fine maps", "mae")))});
    const char* const kEnergy = "energy_ratio[floor]";
    const Estimate part = compare_values(evidence, "fig12", 0, "clamped part", "clamped", kEnergy);
    const Estimate added = compare_values(evidence, "fig12", 0, "added", "clamped", kEnergy);
    judge.set(
        "SSDO-066",
        {combine({judge_below(part, 0.0), judge_below(added, 0.0)}),
         "a near bounce brings the floor's energy nearer to one bounce path traced, as the "
         "part that the clamp took and plainly added",
         added,
         fmt::format("{}, 64 virtual lights; measured: stops from the truth, added - clamped. "
                     "Clamped part - clamped {}; the clamped {}",
                     describe_round(evidence, "fig12"), describe_estimate(part),
                     describe_estimate(estimate_value(evidence, "fig12", 0, "clamped", kEnergy)))});
}

} // namespace

void judge_ssdo_shadows(const Evidence& evidence, Judge& judge) {
    judge_figure6(evidence, judge);
    judge_figure9(evidence, judge);
    judge_virtual_lights(evidence, judge);
    judge.set_untestable({"SSDO-055"}, "a formula: methods_shadow_correction_test holds it against "
                                       "planes of any slope");
    judge.set_untestable({"SSDO-062", "SSDO-063"},
                         "256 lights with maps of 512 texels take minutes a frame on a processor; "
                         "32 of 128 stand for them");
    judge.set_untestable({"SSDO-076"}, "a definition, which no run shows");
    judge.set_untestable({"SSDO-077"},
                         "methods_shadow_correction_test shrinks a blocker below a pixel");
}

} // namespace alcove
