// Trade-offs of runs made by hand.

#include "reports/analysis/metric_table.hpp"
#include "tests/reports/synthetic_run.hpp"
#include "tests/reports/tradeoff_runs.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

Labels list_front(const Tradeoff& tradeoff) {
    Labels labels;
    for (const TradeoffPoint& point : tradeoff.points) {
        if (point.is_on_front) {
            labels.push_back(point.label);
        }
    }
    return labels;
}

void set_errors(CellAnalysis& cell, int begin, const std::vector<double>& errors, int segment = 0) {
    for (std::size_t i = 0; i < errors.size(); ++i) {
        cell.frame_errors.push_back(
            {segment, begin + static_cast<int>(i), "rmse", errors[i], std::nullopt});
    }
}

TEST(Tradeoff, TheFrontHoldsWhatNothingBeatsInBoth) {
    const std::vector<Tradeoff> tradeoffs = compute_tradeoffs(make_simple_run(0.01));
    ASSERT_EQ(tradeoffs.size(), 1u);
    EXPECT_EQ(list_labels(tradeoffs[0].points), (Labels{"a:n=1", "a:n=4", "b", "slow"}));
    EXPECT_EQ(list_front(tradeoffs[0]), (Labels{"a:n=1", "a:n=4", "slow"}));
}

TEST(Tradeoff, SurelyBeatenNeedsBothIntervalsApart) {
    const auto is_beaten = [](double time_width, double error_width) {
        const RunAnalysis run = make_run({make_round(
            "r0", {make_cell("a", known(1.0, 0.01), "rmse", known(0.02, 0.001)),
                   make_cell("b", known(2.0, time_width), "rmse", known(0.04, error_width))})});
        const Tradeoff tradeoff = compute_tradeoffs(run).at(0);
        EXPECT_FALSE(tradeoff.points[1].is_on_front);
        EXPECT_FALSE(tradeoff.points[0].is_surely_beaten);
        return tradeoff.points[1].is_surely_beaten;
    };
    EXPECT_TRUE(is_beaten(0.1, 0.002));
    EXPECT_FALSE(is_beaten(1.5, 0.002)) << "times overlap";
    EXPECT_FALSE(is_beaten(0.1, 0.03)) << "errors overlap";
}

TEST(Tradeoff, RoundsOfTheSameImagesAreJoinedAndOthersKeptApart) {
    const auto make = [](const char* id, const char* label, double time, double error) {
        return make_round(id, {make_cell(label, known(time, 0.01), "rmse", known(error, 0.001))});
    };
    RunAnalysis run = make_run({make("r0", "a", 1.0, 0.08), make("r1", "b", 2.0, 0.04)});
    const std::vector<Tradeoff> joined = compute_tradeoffs(run);
    ASSERT_EQ(joined.size(), 1u);
    EXPECT_EQ(joined[0].points[0].round, "r0");
    EXPECT_EQ(joined[0].points[1].round, "r1");

    const auto count_alone = [&](auto change) {
        RunAnalysis changed = run;
        change(changed.rounds[1].round);
        return compute_tradeoffs(changed).size();
    };
    EXPECT_EQ(count_alone([](RoundRecord& round) { round.scene = "yard"; }), 0u);
    EXPECT_EQ(count_alone([](RoundRecord& round) { round.walkthrough = "other"; }), 0u);
    EXPECT_EQ(count_alone([](RoundRecord& round) { round.target = "radius=2 m"; }), 0u);
    EXPECT_EQ(count_alone([](RoundRecord& round) { round.width = 65; }), 0u);
    EXPECT_EQ(count_alone([](RoundRecord& round) { round.height = 49; }), 0u);
    EXPECT_EQ(count_alone([](RoundRecord& round) { round.precision = "16F"; }), 0u);
    EXPECT_EQ(count_alone([](RoundRecord& round) { round.reference.label = "other"; }), 0u);
    EXPECT_EQ(count_alone([](RoundRecord& round) { round.warm = true; }), 0u);
    EXPECT_EQ(count_alone([](RoundRecord& round) { round.segments[0].end = 15; }), 0u);
}

TEST(Tradeoff, WhereHigherIsBetterTheFrontTurns) {
    const auto make = [](const char* label, double time, double value) {
        return make_cell(label, known(time, 0.01), "ssim", known(value, 0.001));
    };
    const RunAnalysis run = make_run(
        {make_round("r0", {make("a", 1.0, 0.80), make("b", 2.0, 0.70), make("c", 3.0, 0.95)})});
    const Tradeoff tradeoff = compute_tradeoffs(run, "ssim").at(0);
    EXPECT_EQ(list_front(tradeoff), (Labels{"a", "c"}));
    EXPECT_TRUE(tradeoff.points[1].is_surely_beaten);
    EXPECT_FALSE(tradeoff.points[2].is_surely_beaten);
    EXPECT_EQ(tradeoff.points[2].equal_time, 0u);
    EXPECT_EQ(tradeoff.points[1].equal_error, 0u);
    ASSERT_EQ(tradeoff.to_quality.size(), 3u);
    EXPECT_DOUBLE_EQ(tradeoff.to_quality[0][0].bound, 0.95 / kQualitySteps[0]);
}

TEST(Tradeoff, PartnersAreCellsOfOtherMethods) {
    const Tradeoff tradeoff = compute_tradeoffs(make_simple_run(0.01)).at(0);
    const auto name = [&](const std::optional<std::size_t>& partner) {
        return partner ? tradeoff.points[*partner].label : "nothing";
    };
    const auto& points = tradeoff.points; // a:n=1, a:n=4, b, slow
    EXPECT_EQ(name(points[0].equal_time), "nothing");
    EXPECT_EQ(name(points[0].equal_error), "b");
    EXPECT_EQ(name(points[1].equal_time), "nothing") << "a:n=1 is its own method's";
    EXPECT_EQ(name(points[1].equal_error), "slow");
    EXPECT_EQ(name(points[2].equal_time), "a:n=4") << "better than a:n=1";
    EXPECT_EQ(name(points[2].equal_error), "a:n=4") << "faster than slow";
    EXPECT_EQ(name(points[3].equal_time), "a:n=4");
    EXPECT_EQ(name(points[3].equal_error), "nothing");
}

TEST(Tradeoff, TimeToQualityCountsFramesUntilTheErrorStaysWithin) {
    RunAnalysis run = make_run(
        {make_round("r0", {make_cell("a", known(3.0, 0.01), "rmse", known(0.10, 0.001)),
                           make_cell("b", known(1.0, 0.01), "rmse", known(0.30, 0.001))})});
    run.rounds[0].round.segments.push_back({30, 33});
    std::vector<CellAnalysis>& cells = run.rounds[0].cells;
    // Bounds: 0.11, 0.125, 0.15, 0.2. The last frame is outside the first; 0.125 is reached for
    // good in the fourth frame only, after a relapse; in the second burst one frame more for 0.2.
    set_errors(cells[0], 10, {0.19, 0.12, 0.14, 0.115});
    set_errors(cells[0], 30, {0.21, 0.12, 0.11}, 1);
    set_errors(cells[1], 10, {0.3, 0.3, 0.3, 0.3});
    set_errors(cells[1], 30, {0.1, 0.1, 0.1}, 1);
    const Tradeoff tradeoff = compute_tradeoffs(run).at(0);
    EXPECT_EQ(tradeoff.points[1].label, "a");
    const std::vector<TimeToQuality>& a = tradeoff.to_quality.at(1);
    ASSERT_EQ(a.size(), 4u);
    EXPECT_DOUBLE_EQ(a[0].bound, 0.11);
    EXPECT_FALSE(a[0].frames);
    EXPECT_FALSE(a[0].time);
    EXPECT_EQ(a[1].frames, 4);
    EXPECT_DOUBLE_EQ(a[1].time.value_or(0.0), 12.0);
    EXPECT_EQ(a[2].frames, 2);
    EXPECT_EQ(a[3].frames, 2);
    for (const TimeToQuality& entry : tradeoff.to_quality.at(0)) {
        EXPECT_FALSE(entry.frames) << "one burst never reaches it";
    }
}

TEST(Tradeoff, AnErrorWithinFromTheStartTakesOneFrameAndAGapIsNoFrameLess) {
    RunAnalysis run = make_run(
        {make_round("r0", {make_cell("a", known(3.0, 0.01), "rmse", known(0.10, 0.001)),
                           make_cell("b", known(1.0, 0.01), "rmse", known(0.30, 0.001))})});
    std::vector<CellAnalysis>& cells = run.rounds[0].cells;
    set_errors(cells[0], 10, {0.1, 0.1, 0.1, 0.1});
    set_errors(cells[1], 10, {0.5, 0.5, 0.5, 0.05});
    cells[1].frame_errors[1].value.reset();
    const Tradeoff tradeoff = compute_tradeoffs(run).at(0);
    EXPECT_EQ(tradeoff.to_quality.at(1).at(0).frames, 1);
    EXPECT_EQ(tradeoff.to_quality.at(0).at(0).frames, 4);
}

TEST(Tradeoff, TimeToQualityNeedsABurstFromAnEmptyHistory) {
    RunAnalysis run = make_simple_run(0.01);
    EXPECT_FALSE(compute_tradeoffs(run).at(0).to_quality.empty());
    run.rounds[0].round.warm = true;
    EXPECT_TRUE(compute_tradeoffs(run).at(0).to_quality.empty());
}

TEST(Tradeoff, AMetricWithoutRowsGivesNothing) {
    EXPECT_TRUE(compute_tradeoffs(make_simple_run(0.01), "ssim").empty());
    EXPECT_TRUE(compute_tradeoffs(make_run({})).empty());
}

TEST(Tradeoff, ErrorsSpreadOverSegmentsOnceThereAreFive) {
    const auto summarize = [](int segments) {
        std::vector<MetricRow> rows;
        for (int segment = 0; segment < segments; ++segment) {
            for (int frame = 0; frame < 2; ++frame) {
                MetricRow row;
                row.segment = segment;
                row.frame = frame;
                row.value = segment + 0.5 * frame;
                row.debiased = *row.value + 1.0;
                rows.push_back(row);
            }
        }
        std::vector<const MetricRow*> pointers;
        for (const MetricRow& row : rows) {
            pointers.push_back(&row);
        }
        return summarize_metric("rmse", pointers, true).content;
    };
    EXPECT_EQ(summarize(5).n, 5u);
    EXPECT_DOUBLE_EQ(summarize(5).value, 3.25);
    EXPECT_DOUBLE_EQ(summarize(5).minimum, 1.25);
    EXPECT_EQ(summarize(4).n, 8u);
    EXPECT_DOUBLE_EQ(summarize(4).minimum, 1.0);
    EXPECT_EQ(summarize(2).n, 4u);
    EXPECT_FALSE(summarize(2).interval);
}

TEST(Tradeoff, AWholeRunGivesItsConvergedErrorsAndItsBursts) {
    const synthetic::TemporaryFolder folder;
    const std::vector<Tradeoff> tradeoffs =
        compute_tradeoffs(analyze_run(synthetic::write_run(folder.path(), {})));
    ASSERT_EQ(tradeoffs.size(), 2u);
    const Tradeoff& tradeoff = tradeoffs[0];
    EXPECT_EQ(tradeoff.state, SampleState::converged);
    EXPECT_EQ(list_labels(tradeoff.points),
              (Labels{"none", "hemisphere_ssao", "tssao", "hemisphere_ssao:samples=64"}));
    EXPECT_EQ(list_front(tradeoff), (Labels{"none", "hemisphere_ssao", "tssao"}));
    EXPECT_NEAR(tradeoff.points[2].error.value, synthetic::true_rmse("tssao", 32), 1e-12);
    EXPECT_EQ(tradeoff.points[2].error.n, 8u);
    EXPECT_TRUE(tradeoff.points[3].is_surely_beaten);
    // 0.003 (1 + 12 / 2^i) is within 1.25 of its limit from i = 6 on: 12 / 2^6 = 0.1875.
    EXPECT_EQ(tradeoff.to_quality.at(2).at(1).frames, 7);
}

} // namespace
} // namespace alcove
