#include "reports/analysis/wording.hpp"
#include "reports/papers/shanmugam_arikan/shanmugam_arikan_parts.hpp"

#include <fmt/core.h>

namespace alcove {
namespace {

constexpr auto kCold = SampleState::cold;
const char* const kTooDark = "false_occlusion:least=0.05";

std::string describe_truth(const Evidence& evidence, const std::string& part,
                           std::size_t round = 0) {
    return "against rays of 4 m, 160 units, " + describe_round(evidence, part, round);
}

/// Both readings of what is not published must agree: with spheres from vertices and all as
/// printed, and with spheres spread over surfaces. Each beside the image-space part that has its
/// neighbours.
Finding judge_combined(const Evidence& evidence, std::size_t round) {
    const auto gain = [&](const char* a, const char* b) {
        return compare_native(evidence, "figure5", a, b, "rmse", round);
    };
    const Estimate printed = gain("as printed", "near, random");
    const Estimate ours = gain("combined", "near");
    return {combine({judge_below(printed, 0.0), judge_below(ours, 0.0)}),
            "rmse of both parts - of the image-space part < 0, as printed and by default", ours,
            fmt::format("{}; measured: by default. As printed {}. Multiplied in place of summed "
                        "{}. Spheres with the area S of a closed surface show S from every side, "
                        "the body S/4 on average (Cauchy): with spheres of half the radius {}, "
                        "multiplied {}. What is left are bodies behind bodies, summed as if they "
                        "hid other directions",
                        describe_truth(evidence, "figure5", round), describe_estimate(printed),
                        describe_estimate(gain("multiplicative", "near")),
                        describe_estimate(gain("silhouettes", "near")),
                        describe_estimate(gain("silhouettes, multiplied", "near")))};
}

void judge_parts(const Evidence& evidence, Judge& judge) {
    judge.set("SA07-012", judge_combined(evidence, kMolecule));
    Finding combined = judge_combined(evidence, kStatue);
    const Estimate dark = estimate_native(evidence, "figure5", "combined", kTooDark);
    const Estimate printed_dark = estimate_native(evidence, "figure5", "as printed", kTooDark);
    combined.outcome =
        combine({combined.outcome, judge_above(dark, 0.0), judge_above(printed_dark, 0.0)});
    combined.tested += "; and some pixels are too dark by 0.05";
    combined.why += fmt::format(". Share of pixels that are too dark: {}, as printed {}",
                                describe_estimate(dark), describe_estimate(printed_dark));
    judge.set("SA07-023", combined);
    const Estimate beyond = evidence.compare_metric(
        find_native("figure5", "near"), find_native("layers", "2 layers"), "rmse", kCold);
    judge.set("SA07-021", {judge_above(beyond, 0.0),
                           "rmse of the image-space part to rays of 160 units - to rays of its own "
                           "reach, 5 units > 0: what it lacks is farther away",
                           beyond, describe_truth(evidence, "figure5")});
    const Estimate over = compare_native(evidence, "occlusion", "combined", "160 units", "mae");
    const Estimate printed_over =
        compare_native(evidence, "occlusion", "as printed", "160 units", "mae");
    const Estimate less =
        compare_native(evidence, "occlusion", "multiplicative", "combined", "mae");
    judge.set(
        "SA07-041",
        {combine({judge_above(over, 0.0), judge_below(less, 0.0)}),
         "mean occlusion of both parts, summed, is above that of rays of 160 units, and lower "
         "when multiplied",
         over,
         fmt::format("{}; measured: by default - rays. As printed {}, since only what has "
                     "vertices has spheres; multiplied - summed {}",
                     describe_round(evidence, "occlusion"), describe_estimate(printed_over),
                     describe_estimate(less))});
}

void judge_rays(const Evidence& evidence, Judge& judge) {
    const char* const kLengths[] = {"160 units", "40 units", "10 units", "2 units"};
    std::vector<Outcome> falling;
    for (std::size_t i = 0; i + 1 < std::size(kLengths); ++i) {
        falling.push_back(judge_below(
            compare_native(evidence, "occlusion", kLengths[i + 1], kLengths[i], "mae"), 0.0));
    }
    judge.set("SA07-016",
              {combine(falling), "mean occlusion falls from rays of 160 to 40, 10 and 2 units",
               compare_native(evidence, "occlusion", "40 units", "160 units", "mae"),
               describe_round(evidence, "occlusion") + "; measured: 40 - 160"});
    const std::string truth = describe_truth(evidence, "rays");
    const Estimate ten = estimate_native(evidence, "rays", "10 units", "ssim");
    judge.set("SA07-017",
              {judge_above(ten, 0.9), "ssim of rays of 10 units to those of 160 above 0.9", ten,
               fmt::format(
                   "{}; 40 units {}, 2 units {}. The broad shade of statue and pedestal on "
                   "what is around is what 10 units, 0.25 m, lose",
                   truth, describe_estimate(estimate_native(evidence, "rays", "40 units", "ssim")),
                   describe_estimate(estimate_native(evidence, "rays", "2 units", "ssim")))});
    const Estimate two = estimate_native(evidence, "rays", "2 units", "gmsd");
    const Estimate without = estimate_native(evidence, "rays", "constant", "gmsd");
    judge.set(
        "SA07-018",
        {judge_below(two, 0.5 * without.value),
         "gmsd of rays of 2 units to those of 160 below half of an image's without any detail", two,
         fmt::format("{}; without detail {}. 2 units, 5 cm, are few pixels at this size", truth,
                     describe_estimate(without))});
}

} // namespace

void judge_shanmugam_arikan_figure5(const Evidence& evidence, Judge& judge) {
    judge_parts(evidence, judge);
    judge_rays(evidence, judge);
}

} // namespace alcove
