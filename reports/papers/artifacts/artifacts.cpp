#include "reports/papers/artifacts/artifacts.hpp"

#include "reports/analysis/wording.hpp"
#include "reports/papers/artifacts/artifacts_parts.hpp"
#include "reports/papers/estimates.hpp"
#include "reports/papers/start_reproduction.hpp"

#include <algorithm>
#include <numbers>

#include <fmt/core.h>

namespace alcove {
namespace {

constexpr auto kCold = SampleState::cold;
const char* const kRipple = "band_profile";
const char* const kOnCorner = "a corner seen square on, against 512 samples of the estimator";

const Artifact& find_artifact(const std::vector<Artifact>& artifacts, const std::string& number) {
    return *std::find_if(artifacts.begin(), artifacts.end(),
                         [&](const Artifact& artifact) { return artifact.number == number; });
}

Finding judge_cost(const Evidence& evidence) {
    const Estimate cost = evidence.compare_costs({"corner", 0, "decoupled, two numbers"},
                                                 {"corner", 0, "five cones"});
    return {judge_above(cost, 1.0), "time decoupled / constant > 1", cost, "five samples a pixel"};
}

void judge_depth(const Evidence& evidence, Judge& judge) {
    const auto at = [](std::size_t distance, std::size_t bits, const char* label) {
        return CellAddress{"depth", 3 * distance + bits, label};
    };
    const auto get_rate = [&](const CellAddress& cell) {
        return evidence.estimate_metric(cell, "false_occlusion", kCold);
    };
    const Estimate literal = get_rate(at(0, 1, "no bias, least cosine 0.15"));
    const Estimate isolated = get_rate(at(2, 0, "least cosine 0.15"));
    judge.set(
        "BLOG-003",
        {judge_below(literal, 0.01),
         "false occlusion of a plane at 3 m with 24 bits below 0.01 at a least cosine of 0.15",
         literal,
         fmt::format("without it {}. What is left is no matter of depth bits but of pixels: "
                     "a depth read at a pixel's centre stands for all of its footprint. "
                     "With that taken out (bias=1), 16 bits at 20 m leave {} without and {} "
                     "with a least cosine",
                     describe_estimate(get_rate(at(0, 1, "no bias, no least cosine"))),
                     describe_estimate(get_rate(at(2, 0, "no least cosine"))),
                     describe_estimate(isolated))});
    judge.set("BLOG-004", compare_metrics(evidence, {"cosines", 0, "least cosine 0.15"},
                                          {"cosines", 0, "least cosine 0.5"}, "rmse", kCold,
                                          "occlusion beside a corner that a least cosine takes "
                                          "away, 512 samples"));
    const char* const kOnPlane = "a plane that leans 45 degrees, footprint taken out";
    const auto rises = [&](std::size_t near_round, std::size_t far_round) {
        return compare_metrics(evidence, at(near_round, 0, "no least cosine"),
                               at(far_round, 0, "no least cosine"), "false_occlusion", kCold,
                               kOnPlane);
    };
    const Finding by_bits =
        compare_metrics(evidence, at(2, 1, "no least cosine"), at(2, 0, "no least cosine"),
                        "false_occlusion", kCold, kOnPlane);
    judge.set("BLOG-005", combine_findings({rises(0, 1), rises(1, 2), by_bits},
                                           "with 16 bits the rate at 20 m is above that at 8 m and "
                                           "that above 3 m; at 20 m it is lower with 24 bits"));
}

void judge_range(const Evidence& evidence, const std::vector<Artifact>& artifacts, Judge& judge) {
    judge.set("BLOG-008", judge_artifact(evidence, find_artifact(artifacts, "4.8")));
    const Estimate one =
        evidence.estimate_metric({"range_one", 0, "range of the ray"}, kRipple, kCold);
    const Estimate many =
        evidence.estimate_metric({"range_many", 0, "range of the longest ray"}, kRipple, kCold);
    const std::string on = "a corner seen along its floor, against the same without the check";
    judge.set("BLOG-009",
              combine_findings(
                  {{judge_above(one, 0.01), "one sample: ripple above 0.01", one, on},
                   {judge_order(one, many, 0.0), "one sample's ripple > that of 64", one, on},
                   {judge_below(many, 0.01), "64 rotated samples: ripple below 0.01", many,
                    on + ": no band is left, but the whole crease is lighter, because rays behind "
                         "the floor end far behind it in depth"}},
                  "bands with one sample that is not rotated, none with many"));
}

void judge_rotation(const Evidence& evidence, const std::vector<Artifact>& artifacts,
                    Judge& judge) {
    judge.set("BLOG-010", judge_artifact(evidence, find_artifact(artifacts, "4.3")));
    const CellAddress clumped{"rotations", 0, "Gram-Schmidt"};
    const CellAddress fixed{"rotations", 0, "fixed frame"};
    const std::string on = "a kernel of 7 in a corner whose floor leans 80 degrees from the view; "
                           "chi square of the angles by tilt: table";
    // Chance leaves 15 +- sqrt(30).
    const Estimate leaning = make_single(measure_angle_chi_square(std::numbers::pi * 80.0 / 180.0));
    const Estimate facing = make_single(measure_angle_chi_square(0.0));
    judge.set(
        "BLOG-011",
        combine_findings(
            {compare_metrics(evidence, fixed, clumped, "band_profile:measure=profile_error", kCold,
                             on),
             {judge_above(leaning, 42.0), "chi square at 80 degrees above 42", leaning, "computed"},
             {judge_below(facing, 1.0), "chi square of a facing normal below 1", facing,
              "computed"}},
            "angles about a leaning normal clump, about a facing one do not, and the image's "
            "profile is nearer to the limit with a fixed frame"));
    judge.set("BLOG-013", compare_metrics(evidence, fixed, clumped, kRipple, kCold, on));
}

void judge_cones(const Evidence& evidence, Judge& judge) {
    const auto at = [](const char* label) { return CellAddress{"corner", 0, label}; };
    const auto count = [&](const char* label) {
        return evidence.estimate_metric(at(label), "band_profile:measure=bands", kCold);
    };
    const Estimate bands = count("five cones");
    judge.set("BLOG-014", {judge_within(bands, 10.0, 12.0),
                           "five bands on each side of the crease: 10, and up to 2 more at the "
                           "crease, where truth itself bends",
                           bands,
                           std::string(kOnCorner) +
                               "; methods_crytek_ssao_test finds a step at each of five reaches"});
    Finding reflected = compare_metrics(evidence, at("five reflected"), at("five cones"), kRipple,
                                        kCold, kOnCorner);
    reflected.why +=
        fmt::format("; bands {} against {}. Its ripple is a jump at the crease: five "
                    "points of a sphere are not balanced about every normal",
                    describe_estimate(count("five reflected")), describe_estimate(bands));
    judge.set("BLOG-015", reflected);
    judge.set("BLOG-023",
              combine_findings({compare_metrics(evidence, at("decoupled, one number"),
                                                at("five cones"), kRipple, kCold, kOnCorner),
                                compare_metrics(evidence, at("decoupled, two numbers"),
                                                at("five cones"), kRipple, kCold, kOnCorner)},
                               "ripple of decoupled indices, as printed and with two random "
                               "numbers, below that of five cones"));
    judge.set("BLOG-024", judge_cost(evidence));
}

void judge_rest(const Evidence& evidence, const std::vector<Artifact>& artifacts, Judge& judge) {
    const auto find_kernel = [&](const char* label) {
        return evidence.find_parameter({"corner", 0, label}, "kernel");
    };
    const bool has_both = find_kernel("five reflected") == "sphere_reflected" &&
                          find_kernel("five cones") == "hemisphere_frame";
    judge.set("BLOG-002", {has_both ? Outcome::holds : Outcome::fails,
                           "spherical and hemispherical kernels ran side by side", std::nullopt,
                           "parameters of the corner's cells"});
    Finding gain = judge_artifact(evidence, find_artifact(artifacts, "4.9"));
    gain.why += ", against ray tracing; baked vertex AO is a method of its own (baked_vertex_ao)";
    judge.set("BLOG-025", gain);
    judge.set_untestable({"BLOG-007"}, "runs do not count samples: the hemisphere's set holds the "
                                       "limit itself, which methods_crytek_ssao_kernel_test checks "
                                       "point by point");
    judge.set_untestable({"BLOG-001"}, "an order of passes: methods/crytek_ssao/README.md lists "
                                       "them, methods_crytek_ssao_test checks them");
}

PaperTable make_catalogue(const Evidence& evidence, const std::vector<Artifact>& artifacts) {
    PaperTable table{"catalogue",
                     "The catalogue: each artefact provoked and removed",
                     "mean over frames; removed is below provoked, frame by frame",
                     {"no.", "artefact", "scalar", "provoked", "removed", "removed by", "verdict"},
                     {}};
    for (const Artifact& artifact : artifacts) {
        const auto measure = [&](const CellAddress& cell) {
            return describe_estimate(evidence.estimate_metric(cell, artifact.metric, kCold));
        };
        table.rows.push_back({artifact.number, artifact.name, artifact.metric, measure(artifact.on),
                              measure(artifact.off), artifact.removed_by,
                              std::string(to_text(judge_artifact(evidence, artifact).outcome))});
    }
    const Finding cost = judge_cost(evidence);
    table.rows.push_back({"4.6", "wrong edges of a multisampled picture", "none of a run: pictures",
                          "", "", "the nearest depth's visibility a sample",
                          std::string(to_text(Outcome::not_testable))});
    table.rows.push_back({"4.10", "a loop that cannot be unrolled", "time over constant indices",
                          describe_estimate(*cost.measured), "1", "constant indices",
                          std::string(to_text(cost.outcome))});
    std::stable_sort(table.rows.begin(), table.rows.end(), [](const auto& one, const auto& other) {
        return one.front().size() < other.front().size() ||
               (one.front().size() == other.front().size() && one.front() < other.front());
    });
    return table;
}

PaperFigure make_pair(const Evidence& evidence, const CellAddress& on, const CellAddress& off,
                      const char* picture, const std::string& title, const std::string& note) {
    PaperFigure figure{title, note, {}};
    for (const CellAddress& cell : {on, off}) {
        const int frame = evidence.get_round(cell.part, cell.round).image_frames.back();
        figure.pictures.push_back(make_cell_picture(evidence, cell, frame, picture, cell.label));
    }
    return figure;
}

std::vector<PaperFigure> make_pairs(const Evidence& evidence,
                                    const std::vector<Artifact>& artifacts) {
    std::vector<PaperFigure> figures;
    for (const Artifact& artifact : artifacts) {
        figures.push_back(make_pair(evidence, artifact.on, artifact.off, "visibility",
                                    artifact.number + " " + artifact.name,
                                    "visibility; removed by " + artifact.removed_by));
    }
    figures.push_back(make_pair(evidence, {"msaa", 0, "pixel's own"}, {"msaa", 0, "nearest depth"},
                                "shaded", "4.6 wrong edges of a multisampled picture",
                                "the picture, 4 samples a pixel, of a pole whose wall is dark"));
    return figures;
}

} // namespace

Reproduction reproduce_artifacts(const Evidence& evidence, const std::string& scale) {
    const std::vector<Artifact> artifacts = list_artifacts();
    Judge judge;
    judge_depth(evidence, judge);
    judge_range(evidence, artifacts, judge);
    judge_rotation(evidence, artifacts, judge);
    judge_cones(evidence, judge);
    judge_rest(evidence, artifacts, judge);
    judge_artifact_formulas(evidence, judge);
    judge.set_untestable({"BLOG-016"},
                         "the error is of the picture, composed over samples, not of the "
                         "visibility, one value a pixel, that metrics of a run look at. Figure 4.6 "
                         "shows it; core_frame_compose_samples_test counts wrong edge pixels of "
                         "both fetches");
    Reproduction reproduction =
        start_reproduction("BLOG", "\"Know your SSAO artifacts\". 2013.", evidence, scale, judge);
    reproduction.tables = {make_catalogue(evidence, artifacts), make_angles_table(),
                           make_indices_table(evidence)};
    reproduction.figures = make_pairs(evidence, artifacts);
    return reproduction;
}

} // namespace alcove
