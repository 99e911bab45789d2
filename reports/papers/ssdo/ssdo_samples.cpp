#include "reports/analysis/wording.hpp"
#include "reports/papers/ssdo/ssdo_parts.hpp"

#include <array>

#include <fmt/core.h>

namespace alcove {
namespace {

constexpr auto kCold = SampleState::cold;
/// What tells a method apart by 0.05 of its visibility: too dark against rays.
const char* const kTooDark = "false_occlusion:least=0.05";

/// Rounds of part `fig5`.
constexpr std::array<const char*, 4> kFig5Scenes{"edge_on_slabs", "lifted_box",
                                                 "statue_on_pedestal", "twisted_columns"};

/// Is a's metric below b's in every round of a part? What each round gives, in words.
Finding compare_rounds(const Evidence& evidence, const std::string& part, std::size_t rounds,
                       const std::string& a, const std::string& b, const std::string& metric,
                       const std::string& tested) {
    std::vector<Outcome> outcomes;
    std::string all;
    for (std::size_t round = 0; round < rounds; ++round) {
        const Estimate difference = compare_values(evidence, part, round, a, b, metric);
        outcomes.push_back(judge_below(difference, 0.0));
        all +=
            fmt::format("{}{}: {} ({})", round == 0 ? "" : "; ", name_scene(evidence, part, round),
                        describe_estimate(difference), to_text(outcomes.back()));
    }
    const Estimate first = compare_values(evidence, part, 0, a, b, metric);
    return {combine(outcomes), tested, first, "measured: the first of " + all};
}

void judge_figure5(const Evidence& evidence, Judge& judge) {
    const Finding layer = compare_rounds(
        evidence, "fig5", kFig5Scenes.size(), "2 layers", "1 layer", kTooDark,
        "A: the share of pixels that are too dark by 0.05 falls with a second layer");
    const Finding samples = compare_rounds(evidence, "fig5", kFig5Scenes.size(),
                                           "64 samples, 1 set", "4 samples, 1 set", "rmse",
                                           "B: rmse falls from 4 to 64 samples of two layers");
    judge.set("SSDO-045",
              combine_findings({layer, samples},
                               "a second layer takes false darkness away (A), and more samples "
                               "take errors away that it leaves (B), on four scenes"));
    judge.set("SSDO-075",
              compare_rounds(evidence, "fig5", kFig5Scenes.size(), "4 layers", "2 layers", "rmse",
                             "rmse falls from one pair of layers to two pairs"));
}

/// rmse of direct (or all) light falls at each fourfold of samples, in both scenes.
Finding judge_convergence(const Evidence& evidence, const std::string& part) {
    constexpr std::array<const char*, 4> kSteps{"4 samples", "16 samples", "64 samples",
                                                "256 samples"};
    std::vector<Finding> findings;
    for (std::size_t i = 0; i + 1 < kSteps.size(); ++i) {
        findings.push_back(
            compare_rounds(evidence, part, 2, kSteps[i + 1], kSteps[i], "rmse",
                           fmt::format("rmse of {} - of {} < 0", kSteps[i + 1], kSteps[i])));
    }
    return combine_findings(findings, "rmse falls from 4 to 16, 64 and 256 samples");
}

void judge_limit(const Evidence& evidence, Judge& judge) {
    const Finding direct = judge_convergence(evidence, "converged_direct");
    const Finding layers = compare_rounds(evidence, "fig5", kFig5Scenes.size(), "2 layers",
                                          "1 layer", "rmse", "rmse falls with a second layer");
    const Finding cameras =
        compare_rounds(evidence, "fig5", kFig5Scenes.size(), "4 layers, 4 cameras", "4 layers",
                       "rmse", "rmse falls with four cameras beside four layers");
    std::vector<Outcome> biased;
    std::string left;
    for (const std::size_t round : {0u, 1u}) {
        const auto get = [&](const char* label) {
            return estimate_value(evidence, "converged", round, label, "rmse");
        };
        // Four times the samples halve what is noise.
        biased.push_back(judge_above(get("256 samples"), 0.5 * get("64 samples").value));
        left += fmt::format(
            "{}{} {} after {}", round == 0 ? "" : ", ", name_scene(evidence, "converged", round),
            describe_estimate(get("256 samples")), describe_estimate(get("64 samples")));
    }
    Finding finding = combine_findings(
        {direct,
         layers,
         cameras,
         {combine(biased), "with a bounce more than half of rmse is left from 64 to 256 samples",
          estimate_value(evidence, "converged", 0, "256 samples", "rmse"), left}},
        "direct light: rmse falls at each fourfold of samples from 4 to 256, with a second layer, "
        "and with four cameras; with a bounce more than half of it is left from 64 to 256");
    finding.why += "; left with a bounce: " + left +
                   ". Solids of these scenes reach into each other, so that consecutive layers are "
                   "no fronts and backs of one solid, as two layers take them";
    judge.set("SSDO-088", finding);
}

/// Time of `what`'s frame / of one view's.
Estimate compare_overhead(const Evidence& evidence, const std::string& part, const char* what) {
    return evidence.compare_frames({part, 0, what}, {part, 0, "one view"});
}

/// 1 + half and twice an overhead in percent.
Outcome judge_alike(const Estimate& ratio, double percent) {
    return judge_within(ratio, 1.0 + 0.005 * percent, 1.0 + 0.02 * percent);
}

void judge_cameras(const Evidence& evidence, Judge& judge) {
    const std::string on = describe_round(evidence, "fig7");
    const Estimate simple = compare_overhead(evidence, "fig7", "four cameras");
    const Estimate large = compare_overhead(evidence, "fig7_large", "four cameras");
    judge.set("SSDO-048", {judge_above(simple, 1.0),
                           "the frame of one view is faster than that with four further cameras",
                           simple, on + "; measured: four cameras / one view"});
    judge.set("SSDO-049", {judge_alike(simple, 56.2),
                           "four cameras' frame / one view's between 1.28 and 2.12: half and twice "
                           "of 56.2 % more",
                           simple, on});
    judge.set("SSDO-051", {judge_alike(simple, 58.0),
                           "four cameras' frame / one view's between 1.29 and 2.16: half and twice "
                           "of 58 % more",
                           simple, on});
    judge.set("SSDO-052",
              {combine({judge_alike(large, 160.0), judge_order(large, simple, 0.0)}),
               "on 1,005,020 triangles four cameras' frame / one view's between 1.8 and 4.2 (half "
               "and twice of 160 % more), and above that of twisted columns",
               large,
               fmt::format("{}; twisted columns {}. A frame that draws its own triangles longer "
                           "hides more of what is added",
                           describe_round(evidence, "fig7_large"), describe_estimate(simple))});
    std::vector<Outcome> outcomes;
    std::string all;
    for (const char* part : {"fig7", "fig7_large"}) {
        for (const char* what : {"two layers", "four cameras"}) {
            const Estimate ratio = compare_overhead(evidence, part, what);
            outcomes.push_back(judge_within(ratio, 1.15, 4.2));
            all += fmt::format("; {}, {}: {}", name_scene(evidence, part, 0), what,
                               describe_estimate(ratio));
        }
    }
    judge.set("SSDO-054",
              {combine(outcomes),
               "two layers and four cameras add between half of 30 % and twice 160 % to a frame",
               simple, "measured: four cameras / one view, twisted columns" + all});

    const Estimate error = compare_values(evidence, "fig7", 0, "four cameras", "one view", "rmse");
    const Estimate colour =
        compare_values(evidence, "fig7", 0, "four cameras", "one view", "chroma_error[wall]");
    judge.set(
        "SSDO-050",
        {combine({judge_below(error, 0.0), judge_below(colour, 0.0)}),
         "four cameras' rmse - one view's < 0, and so its chroma_error on the wall behind "
         "the hidden column",
         error,
         fmt::format("{}, against path tracing; measured: rmse. Colour of the wall {}; rmse "
                     "of the wall {}, of the floor {}; without a bounce {}",
                     on, describe_estimate(colour),
                     describe_estimate(compare_values(evidence, "fig7", 0, "four cameras",
                                                      "one view", "rmse[wall]")),
                     describe_estimate(compare_values(evidence, "fig7", 0, "four cameras",
                                                      "one view", "rmse[floor]")),
                     describe_estimate(compare_values(evidence, "fig7", 0, "direct, four cameras",
                                                      "direct, one view", "rmse")))});
    const CellAddress cell{"fig7", 0, "four cameras"};
    const std::string share = evidence.find_parameter(cell, "view_resolution");
    judge.set("SSDO-053",
              {evidence.find_parameter(cell, "views") == "4" && share == "0.5" ? Outcome::holds
                                                                               : Outcome::fails,
               "four further cameras with half the sides of the viewer's image, moved by the "
               "bounding radius",
               std::nullopt,
               "view_spread " + evidence.find_parameter(cell, "view_spread") +
                   " bounding radii, view_resolution " + share});
}

/// Does a metric rise in every step of a part's rounds, whose targets' radii double?
Finding judge_rising(const Evidence& evidence, const std::string& part, std::size_t first,
                     const std::string& label, const std::string& metric,
                     const std::string& tested) {
    constexpr std::size_t kSteps = 4;
    std::vector<Outcome> outcomes;
    std::string all;
    for (std::size_t i = 0; i < kSteps; ++i) {
        all += (i == 0 ? "" : ", ") +
               describe_estimate(estimate_value(evidence, part, first + i, label, metric));
        if (i > 0) {
            outcomes.push_back(
                judge_above(evidence.compare_metric({part, first + i, label},
                                                    {part, first + i - 1, label}, metric, kCold),
                            0.0));
        }
    }
    return {combine(outcomes), tested,
            evidence.compare_metric({part, first + kSteps - 1, label}, {part, first, label}, metric,
                                    kCold),
            describe_round(evidence, part, first) + "; measured: largest - smallest; at each " +
                all};
}

void judge_radius(const Evidence& evidence, Judge& judge) {
    judge.set("SSDO-068",
              combine_findings({judge_rising(evidence, "fig14_shadow", 0, "SSDO", kTooDark,
                                             "pixels that lose 0.05 of their visibility"),
                                judge_rising(evidence, "fig14_bounce", 0, "SSDO", "false_occlusion",
                                             "pixels that a bounce brightens by 0.01")},
                               "shares of pixels in shadow and in bounced light rise at each "
                               "doubling of r_max"));
    std::vector<Finding> findings;
    for (std::size_t scene = 0; scene < 2; ++scene) {
        findings.push_back(judge_rising(evidence, "silhouettes", 4 * scene, "1 layer", kTooDark,
                                        "one layer darkens more at each doubling of r_max"));
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t round = 4 * scene + i;
            const Estimate less =
                compare_values(evidence, "silhouettes", round, "2 layers", "1 layer", kTooDark);
            findings.push_back({judge_below(less, 0.0), "two layers darken less than one", less,
                                describe_round(evidence, "silhouettes", round) + ", " +
                                    evidence.get_round("silhouettes", round).target});
        }
    }
    judge.set("SSDO-085",
              combine_findings(findings, "pixels that are darker than rays find by 0.05 with one "
                                         "layer: more at each doubling of r_max, fewer with two "
                                         "layers at each"));
}

/// Root mean square gradient of occlusion over its mean, frame by frame: how hard its edges are,
/// however much of it there is.
std::vector<double> get_hardness(const Evidence& evidence, std::size_t round, const char* label) {
    const CellAddress cell{"fade", round, label};
    std::vector<double> hardness = evidence.get_values(cell, "gradient_error", kCold);
    const std::vector<double> means = evidence.get_values(cell, "mae", kCold);
    for (std::size_t i = 0; i < hardness.size(); ++i) {
        hardness[i] /= means.at(i);
    }
    return hardness;
}

void judge_fade(const Evidence& evidence, Judge& judge) {
    std::vector<Finding> findings;
    std::string all;
    for (std::size_t round = 0; round < 3; ++round) {
        std::vector<double> ratios = get_hardness(evidence, round, "fades");
        const std::vector<double> hard = get_hardness(evidence, round, "ends at once");
        for (std::size_t i = 0; i < ratios.size(); ++i) {
            ratios[i] /= hard.at(i);
        }
        const Estimate ratio = estimate_across_repeats(ratios);
        findings.push_back({judge_below(ratio, 1.0), "edges are softer with the smooth step", ratio,
                            describe_round(evidence, "fade", round)});
        all +=
            fmt::format("; {} {}", name_scene(evidence, "fade", round), describe_estimate(ratio));
    }
    Finding finding = combine_findings(
        findings, "gradient of occlusion over its mean, with the smooth step / without, below 1");
    finding.why += all;
    judge.set("SSDO-083", finding);
}

void judge_distance(const Evidence& evidence, Judge& judge) {
    const auto get = [&](std::size_t round) {
        return estimate_value(evidence, "distance", round, "SSDO", "mae");
    };
    std::vector<Outcome> falls;
    std::string all;
    for (std::size_t round = 0; round < 4; ++round) {
        all += (round == 0 ? "" : ", ") + describe_estimate(get(round));
        if (round > 0) {
            const Estimate step = evidence.compare_metric(
                {"distance", round, "SSDO"}, {"distance", round - 1, "SSDO"}, "mae", kCold);
            // No more than half of it may go at once.
            const double most = 0.5 * get(round - 1).value;
            falls.push_back(judge_within(step, -most, 0.0));
        }
    }
    const Estimate whole =
        evidence.compare_metric({"distance", 3, "SSDO"}, {"distance", 0, "SSDO"}, "mae", kCold);
    judge.set("SSDO-086",
              {combine(falls),
               "mean occlusion falls at each halving of the image, as a camera twice as "
               "far away sees it, and by no more than half",
               whole,
               describe_round(evidence, "distance") +
                   " and less; measured: smallest - largest; at each " + all +
                   ". Angles are not tested"});
    judge.set("SSDO-087", {judge_below(whole, 0.0),
                           "mean occlusion at an eighth of the size - at the whole < 0", whole,
                           describe_round(evidence, "distance") + "; at each size " + all});
}

void judge_parameters(const Evidence& evidence, Judge& judge) {
    const CellAddress printed = find_table1_cell(0, "bounce", 16);
    const auto is = [&](const char* parameter, const char* value) {
        return evidence.find_parameter(printed, parameter) == value ? Outcome::holds
                                                                    : Outcome::fails;
    };
    const std::string on = "what part table1 ran";
    judge.set("SSDO-032", {is("tile", "4"), "sets of samples are those of a tile of 4x4 pixels",
                           std::nullopt, on});
    judge.set("SSDO-073", {combine({is("tile", "4"), is("samples", "16"), is("blur", "true")}),
                           "16 sets of N samples, and a blur over them", std::nullopt, on});
    judge.set("SSDO-071",
              {is("distance_clamp", "1"), "distances of senders are 1 or more", std::nullopt,
               on + "; at a radius of " + evidence.find_parameter(printed, "radius") +
                   " m it makes a bounce dim: half the radius by default"});
    judge.set("SSDO-072", {is("bounce_strength", "1"),
                           "a sender's patch is pi r_max^2 / N, times 1", std::nullopt, on});
}

} // namespace

void judge_ssdo_samples(const Evidence& evidence, Judge& judge) {
    judge_figure5(evidence, judge);
    judge_limit(evidence, judge);
    judge_cameras(evidence, judge);
    judge_radius(evidence, judge);
    judge_fade(evidence, judge);
    judge_distance(evidence, judge);
    judge_parameters(evidence, judge);
}

} // namespace alcove
