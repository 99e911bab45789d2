#include "reports/analysis/series.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/papers/shanmugam_arikan/shanmugam_arikan_parts.hpp"

#include <fmt/core.h>

namespace alcove {
namespace {

/// One pass of a cell in two rounds of a part, each in units of its round's anchor: what drifts
/// from round to round falls on both.
Estimate compare_rounds(const Evidence& evidence, const std::string& part, const std::string& label,
                        const char* pass, std::size_t a, std::size_t b) {
    const auto divide = [](double x, double y) { return x / y; };
    const auto get = [&](std::size_t round) {
        return combine_repeats(evidence.get_passes_ms(find_native(part, label, round), {pass}),
                               evidence.get_cost_ms({part, round, "anchor"}), divide);
    };
    std::vector<double> ratios;
    for (const auto& [repeat, ratio] : combine_repeats(get(a), get(b), divide)) {
        ratios.push_back(ratio);
    }
    return estimate_across_repeats(ratios);
}

/// One pass of cell a over that of cell b.
Estimate compare_pass(const Evidence& evidence, const CellAddress& a, const CellAddress& b,
                      const char* pass) {
    return evidence.compare_passes(a, {pass}, b, {pass});
}

void judge_neighbours(const Evidence& evidence, Judge& judge) {
    std::vector<std::map<int, double>> times;
    for (const double count : list_neighbour_counts()) {
        const auto label = std::to_string(static_cast<int>(count));
        times.push_back(evidence.get_passes_ms(find_native("neighbours", label), {kNearPass}));
    }
    const Estimate fit = estimate_linearity(list_neighbour_counts(), times);
    judge.set("SA07-033", {judge_above(fit, 0.98),
                           "time of the near pass is linear in 8 to 256 neighbours: r^2 > 0.98",
                           fit, describe_round(evidence, "neighbours")});
    const Estimate near = compare_rounds(evidence, "distance", "near", kNearPass, 0, 1);
    const Estimate far = compare_rounds(evidence, "distance", "near", kNearPass, 1, 2);
    judge.set("SA07-014",
              {combine({judge_above(near, 1.0), judge_above(far, 1.0)}),
               "time of the near pass falls from a plane at 3 m to one at 6 and at 12 m, where the "
               "reach has as many pixels as there are neighbours",
               near,
               fmt::format("{}; measured: 3 m / 6 m, four times the neighbours; 6 m / 12 m {}",
                           describe_round(evidence, "distance"), describe_estimate(far))});
}

/// Time of the far pass rises at each smaller cut-off.
std::vector<Outcome> judge_rising_fill(const Evidence& evidence) {
    std::vector<Outcome> outcomes;
    const std::span<const FillStep> steps = list_fill_steps();
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        outcomes.push_back(
            judge_above(compare_pass(evidence, find_native("fill", steps[i + 1].label, kUncut),
                                     find_native("fill", steps[i].label, kUncut), kFarPass),
                        1.0));
    }
    return outcomes;
}

/// r^2 of the far pass's time against the billboards' area.
Estimate fit_fill(const Evidence& evidence, std::size_t round) {
    std::vector<double> areas;
    std::vector<std::map<int, double>> times;
    for (const FillStep& step : list_fill_steps()) {
        areas.push_back(step.get_area());
        times.push_back(evidence.get_passes_ms(find_native("fill", step.label, round), {kFarPass}));
    }
    return estimate_linearity(areas, times);
}

void judge_fill(const Evidence& evidence, Judge& judge) {
    const auto count = [&](std::size_t round) {
        return compare_pass(evidence, find_native("fill", "epsilon 0.1", round),
                            find_native("fill", "1000 spheres", round), kFarPass);
    };
    const Estimate fit = fit_fill(evidence, kUncut);
    std::vector<Outcome> outcomes = judge_rising_fill(evidence);
    outcomes.push_back(judge_above(fit, 0.98));
    outcomes.push_back(judge_below(count(kUncut), 2.0));
    judge.set(
        "SA07-039",
        {combine(outcomes),
         "time of the far pass rises at each smaller epsilon, linearly in the billboards' "
         "area (r^2 > 0.98), and six times the spheres, each of a sixth of the area, cost "
         "less than twice as much",
         fit,
         fmt::format("{}; measured: r^2. 6000 spheres / 1000 {}. Where the image's border "
                     "cuts billboards off, {}: r^2 {}, 6000 / 1000 {}",
                     describe_round(evidence, "fill", kUncut), describe_estimate(count(kUncut)),
                     describe_round(evidence, "fill", kCut),
                     describe_estimate(fit_fill(evidence, kCut)), describe_estimate(count(kCut)))});
}

/// The two numbers that a user sets.
void judge_controls(const Evidence& evidence, Judge& judge) {
    std::vector<Outcome> controls = judge_rising_fill(evidence);
    const char* const kReaches[] = {"1.25 units", "2.5 units", "5 units", "10 units"};
    for (std::size_t i = 0; i + 1 < std::size(kReaches); ++i) {
        controls.push_back(judge_above(compare_pass(evidence, find_native("r_far", kReaches[i + 1]),
                                                    find_native("r_far", kReaches[i]), kNearPass),
                                       1.0));
    }
    judge.set("SA07-047",
              {combine(controls),
               "each doubling of r_far makes the near pass slower, each smaller epsilon the far "
               "pass",
               compare_pass(evidence, find_native("r_far", "10 units"),
                            find_native("r_far", "1.25 units"), kNearPass),
               describe_round(evidence, "r_far") + "; measured: near pass at 10 units / at 1.25"});
}

void judge_shares(const Evidence& evidence, Judge& judge) {
    const auto at = [](const char* label) { return find_native("shares", label); };
    const std::string on = describe_round(evidence, "shares");
    const Estimate printed = evidence.compare_frames(at("near"), at("as printed"));
    const Estimate ours = evidence.compare_frames(at("near"), at("combined"));
    // The far part takes 1 - 34/36 of the paper's frame; half and twice of that are alike.
    constexpr double kShare = 1.0 - 34.0 / 36.0;
    const auto judge_alike = [](const Estimate& ratio) {
        return judge_within(ratio, 1.0 - 2.0 * kShare, 1.0 - 0.5 * kShare);
    };
    judge.set("SA07-022",
              {combine({judge_alike(printed), judge_alike(ours)}),
               "frame with the image-space part / with both between 0.889 and 0.972 (the paper: "
               "0.944), 6000 spheres as printed and by default",
               printed,
               fmt::format("{}; measured: as printed; by default {}. Spheres from vertices "
                           "are small where triangles are; spread over surfaces the floor's "
                           "alone fill the image",
                           on, describe_estimate(ours))});
    const Estimate alone = evidence.compare_frames(at("as printed, far"), at("near"));
    const Estimate ours_alone = evidence.compare_frames(at("far"), at("near"));
    constexpr double kBound = 36.0 / 80.0;
    judge.set(
        "SA07-038",
        {combine({judge_below(alone, kBound), judge_below(ours_alone, kBound)}),
         "frame with 6000 spheres alone / with the image-space part alone below 36/80, as "
         "printed and by default",
         alone,
         fmt::format("{}; the paper's 80 and 36 fps may be of two scenes; measured: as "
                     "printed; by default {}. Without the base G-buffer that both frames "
                     "have {} and {}",
                     on, describe_estimate(ours_alone),
                     describe_estimate(evidence.compare_costs(at("as printed, far"), at("near"))),
                     describe_estimate(evidence.compare_costs(at("far"), at("near"))))});
}

void judge_polygons(const Evidence& evidence, Judge& judge) {
    constexpr std::size_t kFew = 0;
    constexpr std::size_t kMillion = 1;
    const auto ratio = [&](const char* label, const char* pass) {
        return compare_rounds(evidence, "polygons", label, pass, kMillion, kFew);
    };
    const Estimate near = ratio("near", kNearPass);
    const Estimate input = evidence.compare_costs(find_native("polygons", "near", kMillion),
                                                  find_native("polygons", "near", kFew));
    judge.set("SA07-032",
              {judge_within(near, 0.75, 1.33),
               "time of the near pass at 1,005,020 triangles / at 17,524 within a third of 1", near,
               fmt::format("{}; the second layer, which is drawn once more, not included: with it "
                           "{}. Far pass {}, its spheres {}",
                           describe_round(evidence, "polygons"), describe_estimate(input),
                           describe_estimate(ratio("far", kFarPass)),
                           describe_estimate(ratio("far", kSpheresPass)))});
}

} // namespace

void judge_shanmugam_arikan_times(const Evidence& evidence, Judge& judge) {
    judge_neighbours(evidence, judge);
    judge_fill(evidence, judge);
    judge_controls(evidence, judge);
    judge_shares(evidence, judge);
    judge_polygons(evidence, judge);
}

} // namespace alcove
