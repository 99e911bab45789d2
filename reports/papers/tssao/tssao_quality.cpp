#include "reports/papers/findings.hpp"
#include "reports/papers/tssao/tssao_parts.hpp"

#include <array>

namespace alcove {
namespace {

constexpr auto kCold = SampleState::cold;
constexpr auto kConverged = SampleState::converged;

Finding judge_stills(const Evidence& evidence, const std::string& part) {
    const auto at = [&part](const char* label) { return CellAddress{part, 0, label}; };
    const std::string on = "eight still views of the cathedral, converged, against 480 samples";
    return combine_findings(
        {compare_metrics(evidence, at(kTssao), at("SSAO weak blur"), "rmse", kConverged, on),
         compare_metrics(evidence, at(kTssao), at("SSAO strong blur"), "rmse", kConverged, on)},
        "converged TSSAO's rmse is lower than SSAO's with weak and with strong blur");
}

void judge_errors(const Evidence& evidence, Judge& judge) {
    const Finding fox_compton = judge_stills(evidence, "stills");
    const Finding ritschel = judge_stills(evidence, "stills_ritschel");
    judge.set("TSSAO-069", fox_compton);
    judge.set("TSSAO-084", fox_compton);
    judge.set("TSSAO-085", ritschel);
    const CellAddress moving_tssao{"moving", 0, kTssao};
    const CellAddress moving_ssao{"moving", 0, kSsao};
    const CellAddress walking_tssao{"walk", 0, kTssao};
    const CellAddress walking_ssao{"walk", 0, kSsao};
    const std::string on = "moving_objects, fixed camera, against 480 samples";
    const std::string on_walk = "a walk through the cathedral against 480 samples";
    judge.set("TSSAO-128",
              combine_findings(
                  {fox_compton, ritschel,
                   compare_metrics(evidence, walking_tssao, walking_ssao, "rmse", kCold, on_walk),
                   compare_metrics(evidence, moving_tssao, moving_ssao, "rmse", kCold, on)},
                  "TSSAO's rmse is not above SSAO's in any part"));
    const Estimate closeness =
        evidence.estimate_metric({"stills_ritschel", 0, kTssao}, "rmse", kConverged);
    judge.set("TSSAO-129", {judge_below(closeness, 0.01),
                            "converged TSSAO is within rmse 0.01 (2.6/255) of 480 samples",
                            closeness, "eight still views of the cathedral"});
    // Before a fixed camera SSAO's noise stands still on the screen: only a walk shows it flicker.
    judge.set("TSSAO-130", compare_metrics(evidence, walking_tssao, walking_ssao,
                                           "temporal_flicker", kCold, on_walk));
    const CellAddress hemisphere{"ray_traced", 0, "TSSAO Ritschel"};
    const CellAddress disc{"ray_traced", 0, "TSSAO Fox & Compton"};
    judge.set("TSSAO-090",
              compare_metrics(evidence, hemisphere, disc, "rmse", kConverged,
                              "eight still views of the cathedral against ray tracing"));
    const RoundRecord& traced = evidence.get_round("ray_traced", 0);
    const bool is_linear = traced.target.find("falloff=linear") != std::string::npos;
    judge.set("TSSAO-089", {is_linear ? Outcome::holds : Outcome::fails,
                            "ray-traced reference, 256 rays of the hemisphere, linear falloff",
                            std::nullopt, traced.target + "; 2 x 128 rays"});
    const Estimate flow = evidence.compare_metric({"motion_precision", 0, kTssao},
                                                  {"motion_precision", 1, kTssao}, "rmse", kCold);
    judge.set("TSSAO-099", {judge_within(flow, -0.0005, 0.0005),
                            "rmse with 16-bit flow - with 32-bit flow within 0.0005 of 0", flow,
                            "moving_objects against ray tracing"});
}

void judge_invalidation(const Evidence& evidence, Judge& judge) {
    const auto at = [](const char* label) { return CellAddress{"invalidation", 0, label}; };
    const std::string on = "a box that leaves the floor, converged start, against ray tracing";
    const auto is_less = [&](const char* a, const char* b, const char* metric) {
        return compare_metrics(evidence, at(a), at(b), metric, kCold, on);
    };
    const Finding quieter = is_less("smooth 32", "full", "temporal_flicker");
    judge.set(
        "TSSAO-082",
        combine_findings({is_less("full", "disocclusion only", "trail_energy"), quieter},
                         "ghost shadow: disocclusion test alone > full; noise: full > smooth"));
    judge.set("TSSAO-112", quieter);
    const Finding longer =
        combine_findings({is_less("smooth 16", "smooth 64", "trail_energy"),
                          is_less("smooth 64", "smooth 256", "trail_energy"),
                          is_less("smooth 256", "disocclusion only", "trail_energy")},
                         "the trail's energy grows with smooth_samples");
    judge.set("TSSAO-135", longer);
    judge.set("TSSAO-111",
              combine_findings({quieter, is_less("smooth 32", "smooth 256", "trail_energy")},
                               "32 samples: less noise than full, less trail than large counts"));
    judge.set("TSSAO-144",
              combine_findings({is_less("graded", "full", "temporal_flicker"),
                                is_less("graded", "disocclusion only", "trail_energy")},
                               "graded confidence: less flicker than full, less trail than none"));
    const Estimate changed =
        evidence.estimate_metric(at("smooth 32"), "history_neighbourhood", kCold);
    judge.set("TSSAO-078", {judge_above(changed, 0.0),
                            "pixels that are not disoccluded lose history to the neighbourhood "
                            "test (share, mean over frames)",
                            changed, on});
}

void judge_motion(const Evidence& evidence, Judge& judge) {
    const auto at = [](std::size_t round) { return CellAddress{"rotation", round, kTssao}; };
    const auto get_invalid = [&](std::size_t round) {
        return evidence.estimate_metric(at(round), "history_invalidated", kCold);
    };
    const Estimate at_one_degree = get_invalid(1);
    judge.set("TSSAO-079", {judge_below(at_one_degree, 0.1),
                            "at a degree a frame less than 0.1 of the pixels lose history a frame",
                            at_one_degree,
                            "a turning bunny on a floor; where they lie is drawn, "
                            "not tested"});
    std::vector<Finding> steps;
    for (std::size_t round = 0; round + 1 < 4; ++round) {
        const Estimate growth =
            evidence.compare_metric(at(round), at(round + 1), "history_invalidated", kCold);
        steps.push_back({judge_below(growth, 0.0), "share at one speed - at the next", growth,
                         "0.25, 1, 3 and 10 degrees a frame"});
    }
    judge.set("TSSAO-108", combine_findings(steps, "the invalidated share grows with the speed"));
    const Estimate small =
        evidence.estimate_metric({"radius", 0, kTssao}, "missed_invalidation", kCold);
    const Estimate large =
        evidence.estimate_metric({"radius", 3, kTssao}, "missed_invalidation", kCold);
    const bool are_apart = small.interval && large.interval;
    judge.set("TSSAO-137",
              {are_apart && large.interval->lower > small.interval->upper   ? Outcome::holds
               : are_apart && large.interval->upper < small.interval->lower ? Outcome::fails
                                                                            : Outcome::inconclusive,
               "missed invalidations at a radius of 1.8 m are above those at 0.1 m", large,
               "a box that leaves the floor"});
    const auto filter = [](const char* label) { return CellAddress{"filter", 0, label}; };
    const std::string on = "a bunny that turns 2 degrees a frame, against 480 samples";
    judge.set("TSSAO-083", compare_metrics(evidence, filter("filter on"), filter("filter off"),
                                           "temporal_flicker", kCold, on));
}

} // namespace

void judge_tssao_quality(const Evidence& evidence, Judge& judge) {
    judge_errors(evidence, judge);
    judge_invalidation(evidence, judge);
    judge_motion(evidence, judge);
}

} // namespace alcove
