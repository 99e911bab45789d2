#include "reports/papers/statvo/statvo_parts.hpp"

namespace alcove {
namespace {

constexpr auto kCold = SampleState::cold;

CellAddress at(const char* label, std::size_t round = kWide) {
    return {"rivals", round, label};
}

Finding judge_slower(const Evidence& evidence, const char* label, std::size_t round) {
    const Estimate ratio = evidence.compare_costs(at(label, round), at("statvo", round));
    return {judge_above(ratio, 1.0), std::string(label) + " / StatVO > 1 in time", ratio,
            describe_views(evidence, "rivals", round)};
}

void judge_published_times(const Evidence& evidence, Judge& judge) {
    const std::string views = describe_views(evidence, "rivals");
    const Finding eleven = judge_slower(evidence, "11 lines", kWide);
    judge.set("STATVO-048", eleven);
    const Finding eight = judge_slower(evidence, "8 lines", kWide);
    const Estimate noise =
        evidence.compare_metric(at("statvo"), at("8 lines"), "flat_noise", kCold);
    judge.set("STATVO-049",
              {combine({eleven.outcome, eight.outcome, judge_below(noise, 0.0)}),
               "faster than 11 and 8 lines, and less noise than 8", eight.measured, views});
    const Finding points = judge_slower(evidence, "17 points", kWide);
    const Finding lines = judge_slower(evidence, "12 lines", kWide);
    judge.set("STATVO-050", points);
    judge.set("STATVO-051", lines);
    std::vector<Outcome> orders;
    for (const std::size_t round : {kWide, kNarrow}) {
        orders.push_back(judge_slower(evidence, "12 lines", round).outcome);
        orders.push_back(judge_above(
            evidence.compare_costs(at("17 points", round), at("12 lines", round)), 1.0));
    }
    judge.set("STATVO-052",
              {combine(orders), "StatVO < 12 lines < 17 points in time, at both sizes",
               evidence.compare_costs(at("17 points"), at("12 lines")),
               views + "; and at 4:3; measured: points / lines"});
    const Finding sixteen = judge_slower(evidence, "16 points", kWide);
    judge.set("STATVO-055", sixteen);
    const Estimate close =
        evidence.compare_metric(at("statvo"), at("16 points"), "flat_noise", kCold);
    judge.set("STATVO-056", {combine({sixteen.outcome, judge_below(close, 0.0)}),
                             "faster than 16 points, and less noise", close,
                             views + "; no close-up; measured: flat_noise"});
    const Estimate sao = evidence.compare_costs(at("statvo"), at("SAO"));
    const Estimate sharper =
        evidence.compare_metric(at("statvo"), at("SAO"), "gradient_error", kCold);
    judge.set("STATVO-057",
              {combine({judge_within(sao, 1.0, 2.25), judge_below(sharper, 0.0)}),
               "StatVO / SAO in time between 1 and 2.25 (the paper: 1.5), and a lower "
               "gradient_error",
               sao,
               views + "; SAO at full resolution takes 11 taps and a 9x9 blur, StatVO's evaluation "
                       "16 filtered fetches"});
}

void judge_noise(const Evidence& evidence, Judge& judge) {
    const std::string views = describe_views(evidence, "noise");
    const auto raw = [](const char* label) { return CellAddress{"noise", 0, label}; };
    std::vector<Outcome> outcomes;
    for (const char* label : {"raw lines", "raw points"}) {
        outcomes.push_back(judge_below(
            evidence.compare_metric(raw("statvo"), raw(label), "flat_noise", kCold), 0.0));
    }
    judge.set("STATVO-070",
              {combine(outcomes),
               "flat_noise is lower than that of points and of lines without blur",
               evidence.compare_metric(raw("statvo"), raw("raw points"), "flat_noise", kCold),
               views + "; what StatVO has are lines where layers end; measured: StatVO - points"});
    // What is left in StatVO is no noise: lines where layers end, which flat_noise counts as well.
    std::vector<Outcome> few;
    for (const char* label : {"17 points", "12 lines"}) {
        few.push_back(judge_below(
            evidence.compare_metric(at("statvo"), at(label), "flat_noise", kCold), 0.0));
    }
    judge.set("STATVO-063",
              {combine(few), "flat_noise is lower than that of 17 points and of 12 lines, blurred",
               evidence.compare_metric(at("statvo"), at("17 points"), "flat_noise", kCold),
               views + "; what StatVO has are lines where layers end; measured: StatVO - points"});
}

void judge_scaling(const Evidence& evidence, Judge& judge) {
    const std::string views = describe_views(evidence, "radius");
    const auto radius = [](const char* label) { return CellAddress{"radius", 0, label}; };
    const Estimate flat = evidence.compare_costs(radius("statvo 2 m"), radius("statvo 0.25 m"));
    judge.set("STATVO-060",
              {judge_within(flat, 0.9, 1.1),
               "time at a radius of 2 m / at 0.25 m between 0.9 and 1.1", flat, views});
    std::vector<Outcome> outcomes;
    Estimate largest;
    for (const char* rival : {"17 points", "12 lines"}) {
        const auto get = [&](std::size_t round) {
            return evidence.compare_costs({"resolution", round, rival},
                                          {"resolution", round, "statvo"});
        };
        outcomes.push_back(judge_order(get(2), get(0), 0.0));
        largest = get(2);
    }
    judge.set("STATVO-062",
              {combine(outcomes),
               "points / StatVO and lines / StatVO in time rise from 160x90 to 640x360", largest,
               "four views of the cathedral, samples as they are; measured: lines / StatVO at "
               "640x360"});
}

} // namespace

void judge_statvo_rivals(const Evidence& evidence, Judge& judge) {
    judge_published_times(evidence, judge);
    judge_noise(evidence, judge);
    judge_scaling(evidence, judge);
}

} // namespace alcove
