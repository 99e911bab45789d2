#include "reports/papers/statvo/statvo_parts.hpp"

#include <cmath>

namespace alcove {
namespace {

constexpr auto kCold = SampleState::cold;
/// With what errors are measured against.
std::string describe_points(const Evidence& evidence, const std::string& part) {
    return "against 256 points of volumetric obscurance, " + describe_views(evidence, part);
}

CellAddress layers(const char* label) {
    return {"layers", 0, label};
}

CellAddress reference(const char* label) {
    return {"reference", 0, label};
}

CellAddress tables(const char* label) {
    return {"tables", 0, label};
}

/// Is a's metric below b's, frame by frame?
Outcome is_below(const Evidence& evidence, const CellAddress& a, const CellAddress& b,
                 const std::string& metric) {
    return judge_below(evidence.compare_metric(a, b, metric, kCold), 0.0);
}

void judge_layers(const Evidence& evidence, Judge& judge) {
    const std::string views = describe_points(evidence, "layers");
    const Estimate halo = evidence.compare_metric({"halos", 0, "4 adaptive"},
                                                  {"halos", 0, "1 layer"}, "halo_width", kCold);
    judge.set("STATVO-026", {judge_below(halo, 0.0),
                             "halos of one layer are wider than those of 4 adaptive ones", halo,
                             "against 64 uniform layers, which have none, " +
                                 describe_views(evidence, "halos") + "; measured: 4 - 1, pixels"});
    const char* const kUniform[] = {"1 layer", "4 uniform", "16 uniform", "32 uniform",
                                    "64 uniform"};
    std::vector<Outcome> falling;
    for (std::size_t i = 0; i + 1 < std::size(kUniform); ++i) {
        falling.push_back(is_below(evidence, layers(kUniform[i + 1]), layers(kUniform[i]), "rmse"));
    }
    judge.set("STATVO-030",
              {combine(falling), "rmse falls from 1 to 4, 16, 32 and 64 uniform layers",
               evidence.compare_metric(layers("64 uniform"), layers("32 uniform"), "rmse", kCold),
               views + "; measured: 64 - 32"});
    const Estimate gained =
        evidence.compare_metric(layers("64 uniform"), layers("1 layer"), "rmse", kCold);
    const Estimate apart =
        evidence.compare_metric(layers("4 adaptive"), layers("64 uniform"), "rmse", kCold);
    const double near = 0.25 * std::abs(gained.value);
    judge.set("STATVO-031",
              {combine({is_below(evidence, layers("2 adaptive"), layers("1 layer"), "rmse"),
                        is_below(evidence, layers("4 adaptive"), layers("2 adaptive"), "rmse"),
                        judge_within(apart, -near, near)}),
               "rmse falls from 1 to 2 to 4 adaptive layers, and 4 are as near to 64 uniform ones "
               "as a quarter of what those gain over one",
               apart, views + "; measured: 4 adaptive - 64 uniform"});
}

void judge_sizes(const Evidence& evidence, Judge& judge) {
    const std::string views = describe_points(evidence, "reference");
    const Estimate regions =
        evidence.compare_metric(reference("four regions"), reference("full"), "rmse", kCold);
    judge.set("STATVO-034",
              {judge_below(regions, 0.0), "rmse with four regions - with one < 0", regions, views});
    const Estimate half = evidence.estimate_metric(tables("half"), "ssim", kCold);
    const Estimate quarter = evidence.estimate_metric(tables("quarter"), "ssim", kCold);
    judge.set("STATVO-038",
              {combine({judge_above(half, 0.95), judge_above(quarter, 0.9),
                        is_below(evidence, reference("full"), reference("half"), "rmse"),
                        is_below(evidence, reference("half"), reference("quarter"), "rmse")}),
               "ssim to full tables above 0.95 (half) and 0.9 (quarter); rmse full < half < "
               "quarter",
               quarter, views + "; measured: ssim of quarter to full"});
    const Estimate equal = evidence.estimate_metric(tables("all tables"), "rmse", kCold);
    judge.set("STATVO-041",
              {judge_below(equal, 1.0 / 255.0),
               "differences of tables are within 1/255 rmse of tables of their own", equal,
               "float32, full resolution; " + describe_views(evidence, "tables")});
    // A step of 4 of 255 is hard to see.
    const Estimate p95 = evidence.estimate_metric(tables("quarter"), "p95_error", kCold);
    judge.set("STATVO-064", {judge_below(p95, 4.0 / 255.0),
                             "95 % of the pixels are within 4/255 of those with full tables", p95,
                             "quarter-resolution tables; " + describe_views(evidence, "tables")});
}

void judge_reference(const Evidence& evidence, Judge& judge) {
    const std::string views = describe_points(evidence, "reference");
    const CellRecord& truth = evidence.get_round("reference", 0).reference;
    std::string samples;
    for (const ParameterRecord& parameter : truth.parameters) {
        samples = parameter.name == "samples" ? parameter.value : samples;
    }
    const Estimate error = evidence.estimate_metric(reference("full"), "rmse", kCold);
    judge.set("STATVO-053", {samples == "256" ? judge_below(error, 0.1) : Outcome::fails,
                             "rmse to 256 points without rotation and blur is below 0.1", error,
                             views + "; samples of the reference: " + samples});
    const Estimate gain =
        evidence.compare_metric(reference("full"), reference("1 layer"), "rmse", kCold);
    judge.set("STATVO-054",
              {judge_below(gain, 0.0), "rmse with 4 adaptive layers - with one < 0", gain, views});
}

void judge_scenes(const Evidence& evidence, Judge& judge) {
    const auto flicker = [](const char* label) { return CellAddress{"flicker", 0, label}; };
    const Estimate rises =
        evidence.compare_metric(flicker("quarter"), flicker("full"), "temporal_flicker", kCold);
    judge.set("STATVO-047",
              {judge_above(rises, 0.0), "temporal_flicker with quarter tables - with full ones > 0",
               rises, "a slow dolly past pillars; where it lies is not tested"});
    const auto pillars = [](const char* label) { return CellAddress{"pillars", 0, label}; };
    const Estimate deeper =
        evidence.compare_metric(pillars("8 layers"), pillars("4 layers"), "rmse", kCold);
    judge.set(
        "STATVO-066",
        {combine({judge_below(deeper, 0.0),
                  judge_order(evidence.estimate_metric(pillars("4 layers"), "rmse", kCold),
                              evidence.estimate_metric(reference("full"), "rmse", kCold), 0.0)}),
         "along a row of pillars rmse is above that of the cathedral, and falls from 4 to 8 "
         "layers",
         deeper, "pillars_in_a_row; measured: 8 - 4"});
}

} // namespace

void judge_statvo_quality(const Evidence& evidence, Judge& judge) {
    judge_layers(evidence, judge);
    judge_sizes(evidence, judge);
    judge_reference(evidence, judge);
    judge_scenes(evidence, judge);
}

} // namespace alcove
