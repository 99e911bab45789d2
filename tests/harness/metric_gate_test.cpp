// What a gate's text means.

#include "harness/app/metric_gate.hpp"
#include "harness/run/units.hpp"
#include "tests/harness/expect_error.hpp"

#include <cmath>

namespace alcove {
namespace {

PairScore make_score(const std::string& name, std::optional<double> value) {
    PairScore score;
    score.name = name;
    score.result.value = value;
    if (value) {
        score.result.extras.push_back({"max", 2.0 * *value});
    }
    return score;
}

bool holds(std::string_view gate, const std::vector<PairScore>& scores) {
    MetricMeans means;
    means.add(scores, "pair");
    return check_gate(parse_gate(gate), means);
}

TEST(MetricGate, ASpecificationMayHoldCommasAndTheNumberEndsAtOne) {
    const std::vector<GateCondition> gate =
        parse_gate("flip@codes:distance_m=0.5,monitor_width_m=1<=0.1, ssim > 0.9,x.y<1e-3");
    ASSERT_EQ(gate.size(), 3u);
    EXPECT_EQ(gate[0].metric, "flip@codes:distance_m=0.5,monitor_width_m=1");
    EXPECT_TRUE(gate[0].is_less && gate[0].or_equal);
    EXPECT_EQ(gate[0].bound, 0.1);
    EXPECT_EQ(gate[1].metric, "ssim");
    EXPECT_EQ(gate[1].text, "ssim > 0.9");
    EXPECT_FALSE(gate[1].is_less || gate[1].or_equal);
    EXPECT_EQ(gate[2].metric, "x.y");
    EXPECT_EQ(gate[2].bound, 1e-3);
}

TEST(MetricGate, WhatCannotBeReadIsRefused) {
    for (const char* text : {"", "mse", "<1", "mse<", "mse<x", "mse<nan", "mse<1,", "mse=1",
                             "mse<1<2", "mse<1 2", ",mse"}) {
        SCOPED_TRACE(text);
        expect_error([text] { static_cast<void>(parse_gate(text)); }, 2, {"--gate"});
    }
}

TEST(MetricGate, EqualityCountsOnlyWhereItIsAskedFor) {
    const std::vector<PairScore> scores{make_score("m", 0.5)};
    EXPECT_TRUE(holds("m<=0.5", scores));
    EXPECT_TRUE(holds("m>=0.5", scores));
    EXPECT_FALSE(holds("m<0.5", scores));
    EXPECT_FALSE(holds("m>0.5", scores));
    EXPECT_TRUE(holds("m<0.6,m>0.4", scores));
    EXPECT_FALSE(holds("m<0.6,m>0.6", scores));
    EXPECT_TRUE(holds("m.max>=1,m.max<=1", scores));
}

TEST(MetricGate, AnUndefinedValueHoldsNothingAndAnUnknownNameIsAnError) {
    const std::vector<PairScore> scores{make_score("m", std::nullopt), make_score("n", 1.0)};
    EXPECT_FALSE(holds("m<inf", scores));
    EXPECT_FALSE(holds("m>=-inf", scores));
    EXPECT_FALSE(holds("m.max<inf", scores));
    expect_error([&] { static_cast<void>(holds("n.mix<1", scores)); }, 2, {"n.mix", "n.max"});
    expect_error([&] { static_cast<void>(holds("o<1", scores)); }, 2, {"--gate", "o"});
}

TEST(MetricGate, OnePairWithoutAValueLeavesNoMean) {
    MetricMeans means;
    means.add({make_score("m", 1.0)}, "first");
    means.add({make_score("m", 2.0)}, "second");
    ASSERT_TRUE(means.find("m"));
    EXPECT_EQ(means.find("m")->mean(), 1.5);
    EXPECT_EQ(means.find("m")->smallest, 1.0);
    EXPECT_EQ(means.find("m")->largest, 2.0);
    means.add({make_score("m", std::nullopt)}, "third");
    EXPECT_EQ(means.find("m")->mean(), std::nullopt);
    EXPECT_EQ(means.find("m.max")->mean(), std::nullopt);
    EXPECT_NE(means.find("m")->describe_lack().find("1 of 3"), std::string::npos);
}

TEST(MetricGate, MetricsThatItSpeaksOfAreMeasured) {
    const Registry<MetricUnit> registry = get_units().metrics;
    const auto list = [&](std::string_view text, bool may_be_key) {
        return list_gated_metrics(parse_gate(text), {"mse"}, registry, may_be_key);
    };
    EXPECT_EQ(list("mse<1,flip:ppd=30.5<1,flip:ppd=30.5>0,flip@codes.max<1", false),
              (std::vector<std::string>{"flip:ppd=30.5", "flip@codes"}));
    EXPECT_EQ(list("lpips<1", false), (std::vector<std::string>{"lpips"}));
    EXPECT_TRUE(list("lpips<1", true).empty());
}

} // namespace
} // namespace alcove
