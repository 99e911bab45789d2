#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/papers/ssdo/ssdo_parts.hpp"

#include <fmt/core.h>

namespace alcove {
namespace {

/// What comparing a and b in every scene of part `fig13` found.
struct Comparison {
    std::vector<Outcome> outcomes;
    std::string exceptions; ///< scenes where it does not hold, with the difference
};

Comparison compare_scenes(const Evidence& evidence, Reach reach, const char* a, const char* b) {
    Comparison comparison;
    for (std::size_t scene = 0; scene < kFig13Scenes; ++scene) {
        const std::size_t round = find_fig13_round(scene, reach);
        const Estimate difference = compare_values(evidence, "fig13", round, a, b, "rmse");
        comparison.outcomes.push_back(judge_below(difference, 0.0));
        if (comparison.outcomes.back() != Outcome::holds) {
            comparison.exceptions += fmt::format(
                "{}{} {} ({})", comparison.exceptions.empty() ? "" : ", ",
                name_scene(evidence, "fig13", round), format_rounded(difference.value, 2),
                to_text(comparison.outcomes.back()));
        }
    }
    return comparison;
}

/// Mean over scenes of each scene's mean rmse, a - b.
Estimate average_scenes(const Evidence& evidence, Reach reach, const char* a, const char* b) {
    std::vector<double> differences;
    for (std::size_t scene = 0; scene < kFig13Scenes; ++scene) {
        differences.push_back(
            compare_values(evidence, "fig13", find_fig13_round(scene, reach), a, b, "rmse").value);
    }
    return estimate_across_repeats(differences);
}

std::string describe_exceptions(const char* pair, const Comparison& comparison) {
    return fmt::format("; {}: {}", pair,
                       comparison.exceptions.empty() ? "no exception" : comparison.exceptions);
}

void judge_order_of_errors(const Evidence& evidence, Judge& judge) {
    std::vector<Outcome> outcomes;
    std::string exceptions;
    const Comparison weights = compare_scenes(evidence, Reach::full, "SSDO", "SSAO, cosine");
    for (const auto& [a, b, words] : {std::tuple{"SSAO", "nothing", "SSAO - nothing"},
                                      std::tuple{"SSDO", "SSAO", "SSDO - SSAO"},
                                      std::tuple{"bounce", "SSDO", "bounce - SSDO"}}) {
        const Comparison comparison = compare_scenes(evidence, Reach::full, a, b);
        outcomes.insert(outcomes.end(), comparison.outcomes.begin(), comparison.outcomes.end());
        exceptions += describe_exceptions(words, comparison);
    }
    judge.set("SSDO-067",
              {combine(outcomes),
               fmt::format("rmse to one-bounce path tracing of all there is falls from nothing to "
                           "SSAO, SSDO, and SSDO with a bounce, in each of {} scenes",
                           kFig13Scenes),
               average_scenes(evidence, Reach::full, "bounce", "nothing"),
               "measured: with a bounce - nothing, over scenes. Exceptions (rmse, mean over "
               "six views)" +
                   exceptions +
                   ". Intervals and where they lie are in the table of figure 13. Not judged: "
                   "without occlusion "
                   "light is the surroundings' mean, with SSAO that of each normal's hemisphere" +
                   describe_exceptions("SSDO - SSAO with SSDO's weights", weights)});
}

void judge_never_worse(const Evidence& evidence, Judge& judge) {
    std::vector<Outcome> outcomes;
    std::string exceptions;
    for (const auto& [reach, words] :
         {std::pair{Reach::near, "near"}, std::pair{Reach::full, "full"}}) {
        const Comparison comparison = compare_scenes(evidence, reach, "SSDO", "SSAO");
        outcomes.insert(outcomes.end(), comparison.outcomes.begin(), comparison.outcomes.end());
        exceptions += describe_exceptions(words, comparison);
    }
    judge.set(
        "SSDO-090",
        {combine(outcomes),
         fmt::format("rmse of SSDO is below SSAO's in each of {} scenes, against path tracing of "
                     "what lies within the radius and of all there is",
                     kFig13Scenes),
         average_scenes(evidence, Reach::near, "SSDO", "SSAO"),
         "measured: SSDO - SSAO over scenes, within the radius. Exceptions" + exceptions +
             ". Flicker is SSDO-080"});
}

void judge_flicker(const Evidence& evidence, Judge& judge) {
    std::vector<Outcome> outcomes;
    std::string all;
    for (std::size_t round = 0; round < 3; ++round) {
        for (const char* what : {"SSDO", "bounce"}) {
            const Estimate difference =
                compare_values(evidence, "flicker", round, what, "SSAO", "temporal_flicker");
            // A tenth of SSAO's own flicker is "no more".
            const Estimate own =
                estimate_value(evidence, "flicker", round, "SSAO", "temporal_flicker");
            outcomes.push_back(judge_below(difference, 0.1 * own.value));
            all += fmt::format(
                "; {}, {}: {} against {} ({})", name_scene(evidence, "flicker", round), what,
                describe_estimate(difference), describe_estimate(own), to_text(outcomes.back()));
        }
    }
    judge.set(
        "SSDO-080",
        {combine(outcomes),
         "temporal_flicker of SSDO, with and without a bounce, is above SSAO's by less than a "
         "tenth of that",
         compare_values(evidence, "flicker", 0, "bounce", "SSAO", "temporal_flicker"),
         "walking figures and moving objects; measured: the first with a bounce - SSAO" + all});
}

} // namespace

void judge_ssdo_truth(const Evidence& evidence, Judge& judge) {
    judge_order_of_errors(evidence, judge);
    judge_never_worse(evidence, judge);
    judge_flicker(evidence, judge);
}

} // namespace alcove
