#include "reports/papers/tssao/tssao_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace alcove {
namespace {

/// One column of Table 2, its claims in the order SSAO, TSSAO, deferred.
struct TableRow {
    const char* part;
    std::size_t round;
    const char* printed;
    std::array<const char*, 3> claims; ///< the last is null where no value is printed
    const char* cost_claim;
};

constexpr std::array kSibenik{
    TableRow{"table2", kLargest, "1600x1200", {"TSSAO-013", "TSSAO-014", "TSSAO-015"}, "TSSAO-035"},
    TableRow{"table2", kMiddle, "1024x768", {"TSSAO-016", "TSSAO-017", "TSSAO-018"}, "TSSAO-036"},
    TableRow{"table2", kSmallest, "800x600", {"TSSAO-019", "TSSAO-020", "TSSAO-021"}, "TSSAO-037"},
    TableRow{"table2_half", 0, "800x600 at half", {"TSSAO-022", "TSSAO-023", nullptr}, "TSSAO-038"},
};

constexpr const char* kCathedral = "cathedral in Sibenik's place, one uncut walk of 60 frames";

std::string describe_size(const Evidence& evidence, const TableRow& row) {
    const RoundRecord& round = evidence.get_round(row.part, row.round);
    return std::string(row.printed) + " as " + std::to_string(round.width) + "x" +
           std::to_string(round.height) + "; " + kCathedral;
}

void judge_table2(const Evidence& evidence, Judge& judge) {
    std::vector<Outcome> orders;
    std::vector<Outcome> faster;
    std::vector<Outcome> advantages;
    for (const TableRow& row : kSibenik) {
        const auto at = [&row](const char* label) {
            return CellAddress{row.part, row.round, label};
        };
        const std::string on = describe_size(evidence, row);
        // fps are reciprocal times: a's fps over b's is b's time over a's.
        const Estimate ssao = evidence.compare_frames(at(kDeferred), at(kSsao));
        judge.set(row.claims[0], {judge_below(ssao, 1.0), "SSAO fps / deferred fps < 1", ssao, on});
        const Estimate tssao = evidence.compare_frames(at(kSsao), at(kTssao16));
        faster.push_back(judge_above(tssao, 1.0));
        judge.set(row.claims[1], {faster.back(), "TSSAO fps / SSAO fps > 1 (k2 = 16)", tssao, on});
        const Estimate deferred = evidence.compare_frames(at(kTssao16), at(kDeferred));
        if (row.claims[2] != nullptr) {
            judge.set(row.claims[2],
                      {judge_above(deferred, 1.0), "deferred fps / TSSAO fps > 1", deferred, on});
        }
        orders.push_back(combine({faster.back(), judge_above(deferred, 1.0)}));
        // Between the samples' share, less a tenth for what is skipped, and 1.
        const Estimate cost = evidence.compare_costs(at(kTssao16), at(kSsao));
        judge.set(row.cost_claim, {judge_within(cost, 0.9 * 16.0 / 32.0, 1.0),
                                   "TSSAO cost / SSAO cost between 0.45 and 1", cost, on});
        advantages.push_back(judge_above(evidence.compare_frames(at(kTssao16), at(kTssao8)), 1.0));
    }
    judge.set("TSSAO-053", {combine(orders), "SSAO < TSSAO < deferred in fps, at every size",
                            std::nullopt, kCathedral});
    judge.set("TSSAO-054", {combine(advantages), "k2 = 8 is faster than k2 = 16 at every size",
                            std::nullopt, std::string(kCathedral) + "; no city here"});
    judge.set("TSSAO-132", {combine(faster), "TSSAO fps / SSAO fps > 1 at full and half resolution",
                            std::nullopt, kCathedral});
}

struct Scaling {
    const char* claim;
    const char* label;
    std::size_t large;
    std::size_t small;
    double tolerance;
};

constexpr std::array kScalings{
    Scaling{"TSSAO-039", kSsao, kLargest, kMiddle, 0.1},
    Scaling{"TSSAO-040", kTssao16, kLargest, kMiddle, 0.2},
    Scaling{"TSSAO-041", kSsao, kMiddle, kSmallest, 0.1},
    Scaling{"TSSAO-042", kTssao16, kMiddle, kSmallest, 0.2},
    Scaling{"TSSAO-043", kSsao, kLargest, kSmallest, 0.1},
    Scaling{"TSSAO-044", kTssao16, kLargest, kSmallest, 0.2},
};

double count_pixels(const RoundRecord& round) {
    return static_cast<double>(round.width) * static_cast<double>(round.height);
}

void judge_pixels(const Evidence& evidence, Judge& judge) {
    for (const Scaling& scaling : kScalings) {
        const CellAddress large{"table2", scaling.large, scaling.label};
        const CellAddress small{"table2", scaling.small, scaling.label};
        const double pixels = count_pixels(evidence.get_round("table2", scaling.large)) /
                              count_pixels(evidence.get_round("table2", scaling.small));
        const Estimate costs = evidence.compare_costs(large, small);
        judge.set(scaling.claim, {judge_within(costs, pixels * (1.0 - scaling.tolerance),
                                               pixels * (1.0 + scaling.tolerance)),
                                  "cost grows as the pixels do", costs,
                                  "milliseconds of one run, rounds one after the other"});
    }
    const CellAddress full_ssao{"table2", kSmallest, kSsao};
    const CellAddress half_ssao{"table2_half", 0, kSsao};
    const CellAddress full_tssao{"table2", kSmallest, kTssao16};
    const CellAddress half_tssao{"table2_half", 0, kTssao16};
    const Estimate gain = evidence.compare_costs(full_ssao, half_ssao);
    judge.set("TSSAO-051",
              {judge_within(gain, 1.0, 4.0), "SSAO at half resolution gains, and less than 4", gain,
               "milliseconds of two runs"});
    const Estimate tssao_gain = evidence.compare_costs(full_tssao, half_tssao);
    // Of a/b and c/d the second is certainly less if its upper end is under the first's lower end.
    const bool is_less =
        tssao_gain.interval && gain.interval && tssao_gain.interval->upper < gain.interval->lower;
    const bool is_more =
        tssao_gain.interval && gain.interval && tssao_gain.interval->lower > gain.interval->upper;
    judge.set("TSSAO-052", {is_less   ? Outcome::holds
                            : is_more ? Outcome::fails
                                      : Outcome::inconclusive,
                            "TSSAO gains less from half resolution than SSAO", tssao_gain,
                            "milliseconds of two runs"});
}

void judge_resolution(const Evidence& evidence, Judge& judge) {
    const auto get_advantage = [&evidence](std::size_t round, const char* tssao) {
        return evidence.compare_frames({"table2", round, kSsao}, {"table2", round, tssao});
    };
    // A fiftieth: less than the paper's own rows differ by.
    constexpr double kSlack = 0.02;
    std::vector<Outcome> outcomes;
    for (const char* tssao : {kTssao16, kTssao8}) {
        for (const auto& [large, small] : {std::pair{kLargest, kMiddle}, {kMiddle, kSmallest}}) {
            outcomes.push_back(
                judge_order(get_advantage(large, tssao), get_advantage(small, tssao), kSlack));
        }
    }
    judge.set("TSSAO-055",
              {combine(outcomes), "TSSAO fps / SSAO fps does not fall as the resolution rises",
               get_advantage(kLargest, kTssao8), kCathedral});
    const CellAddress ssao{"table2", kLargest, kSsao};
    const Estimate deferred = evidence.compare_frames({"table2", kLargest, kDeferred}, ssao);
    judge.set("TSSAO-086", {judge_below(deferred, 1.0), "SSAO fps / deferred fps < 1", deferred,
                            std::string(kCathedral) + ", without the bunny"});
    const Estimate advantage = get_advantage(kLargest, kTssao8);
    judge.set("TSSAO-087", {judge_above(advantage, 1.0), "TSSAO fps / SSAO fps > 1 (k2 = 8)",
                            advantage, std::string(kCathedral) + ", without the bunny"});
    judge.set("TSSAO-088", {judge_order(advantage, get_advantage(kMiddle, kTssao8), 0.0),
                            "the advantage in speed is larger at 1600x1200 than at 1024x768",
                            advantage, "speed alone: there is no metric of detail yet"});
}

void judge_figure1(const Evidence& evidence, Judge& judge) {
    const auto at = [](const char* label) { return CellAddress{"costs", 0, label}; };
    const auto still = [](const char* label) { return CellAddress{"stills", 0, label}; };
    const Estimate ssao = evidence.compare_frames(at(kDeferred), at("SSAO filtered"));
    judge.set("TSSAO-063",
              {judge_below(ssao, 1.0), "SSAO fps / deferred fps < 1", ssao, kCathedral});
    const Estimate converged = evidence.compare_converged(still(kTssao), still("SSAO weak blur"));
    judge.set("TSSAO-064",
              {judge_below(converged, 1.0), "converged TSSAO costs less than SSAO (passes alone)",
               converged, "two still views, histories converged"});
    const Estimate reference = evidence.compare_frames(at("SSAO 480"), at("SSAO 32"));
    judge.set("TSSAO-065", {judge_above(reference, 1.0), "SSAO-32 fps / reference fps > 1",
                            reference, kCathedral});
    const Estimate deferred = evidence.compare_frames(at("TSSAO packed"), at(kDeferred));
    judge.set("TSSAO-066",
              {judge_above(deferred, 1.0), "deferred fps / TSSAO fps > 1", deferred, kCathedral});
    Estimate linear = evidence.compare_costs(at("SSAO 480"), at("SSAO 32"));
    linear = scale_estimate(linear, 32.0 / 480.0);
    const Finding proportional{judge_within(linear, 0.85, 1.15),
                               "cost per sample at 480 / at 32 within 15 % of 1", linear,
                               std::string(kCathedral) + ", without filter"};
    judge.set("TSSAO-067", proportional);
    judge.set("TSSAO-095", proportional);
    const Estimate per_sample = scale_estimate(converged, 32.0 / 8.0);
    judge.set("TSSAO-068", {judge_below(per_sample, 1.0),
                            "converged TSSAO costs no more per sample than SSAO", per_sample,
                            "passes alone; a software device pays for reprojection what a texture "
                            "unit hides"});
    const Estimate rotation = evidence.compare_costs(at("SSAO 32"), at("SSAO 32 unrotated"));
    judge.set("TSSAO-116",
              {judge_above(rotation, 1.0), "rotated kernels cost more than unrotated ones",
               rotation, "a texture-cache effect, on a device without one of its own"});
    const Estimate packing = evidence.compare_costs(at("TSSAO packed"), at("TSSAO separate"));
    judge.set("TSSAO-142",
              {judge_below(packing, 1.0), "depth and flow in one target cost less than in two",
               packing, kCathedral});
    const Estimate unadapted = evidence.compare_costs(at("TSSAO k2=32"), at("SSAO filtered"));
    judge.set("TSSAO-139", {judge_within(unadapted, 0.8, 1.3),
                            "with k2 = k1 TSSAO costs about what SSAO does (0.8 to 1.3)", unadapted,
                            kCathedral});
}

void judge_figure13(const Evidence& evidence, Judge& judge) {
    const std::vector<double> ssao = evidence.get_frame_costs_ms({"table2", kMiddle, kSsao});
    const std::vector<double> tssao = evidence.get_frame_costs_ms({"table2", kMiddle, kTssao16});
    std::size_t ordered = 0;
    for (std::size_t i = 0; i < std::min(ssao.size(), tssao.size()); ++i) {
        ordered += tssao[i] > 0.0 && tssao[i] <= ssao[i] ? 1 : 0;
    }
    Estimate share = make_single(static_cast<double>(ordered) / static_cast<double>(ssao.size()));
    share.n = ssao.size();
    judge.set("TSSAO-092",
              {judge_above(share, 0.9), "deferred <= TSSAO <= SSAO on more than 0.9 of the frames",
               share, std::string(kCathedral) + "; nothing moves in it"});
    const CellAddress moving_tssao{"moving", 0, kTssao};
    const CellAddress moving_ssao{"moving", 0, kSsao};
    const std::vector<double> costs = evidence.get_frame_costs_ms(moving_tssao);
    const std::vector<double> samples =
        evidence.get_values(moving_tssao, "history_samples", SampleState::cold);
    const Estimate correlation = correlate(costs, samples);
    judge.set("TSSAO-093", {judge_above(correlation, 0.0),
                            "a frame's cost rises with the samples that its pixels take "
                            "(correlation over frames)",
                            correlation, "moving_objects, fixed camera; no close-up"});
    const auto find_largest = [](const std::vector<double>& values) {
        return *std::max_element(values.begin(), values.end());
    };
    Estimate worst =
        make_single(find_largest(costs) / find_largest(evidence.get_frame_costs_ms(moving_ssao)));
    worst.n = costs.size();
    judge.set("TSSAO-138",
              {judge_above(worst, 0.95),
               "the slowest TSSAO frame is as slow as the slowest SSAO frame (0.95)", worst,
               "moving_objects, converged start; no close-up of a large moving object"});
}

} // namespace

void judge_tssao_times(const Evidence& evidence, Judge& judge) {
    judge_table2(evidence, judge);
    judge_pixels(evidence, judge);
    judge_resolution(evidence, judge);
    judge_figure1(evidence, judge);
    judge_figure13(evidence, judge);
}

} // namespace alcove
