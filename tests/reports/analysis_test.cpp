#include "reports/analysis/analysis.hpp"
#include "reports/analysis/wording.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace alcove {
namespace {

using synthetic::TemporaryFolder;

const CellAnalysis& find_cell(const RoundAnalysis& round, const std::string& id) {
    return *std::find_if(round.cells.begin(), round.cells.end(),
                         [&](const CellAnalysis& cell) { return cell.cell.id == id; });
}

/// Every frame of every segment.
std::vector<int> list_frames() {
    std::vector<int> frames;
    const PlanRecord plan = synthetic::make_plan({});
    for (const SegmentRecord& segment : plan.rounds[0].segments) {
        for (int frame = segment.begin; frame < segment.end; ++frame) {
            frames.push_back(frame);
        }
    }
    return frames;
}

/// In each of six repeats the median over the frames that the repeat times undivided.
std::map<int, double> make_cold_medians_ms(const std::string& cell) {
    std::map<int, double> medians;
    for (int repeat = 0; repeat < 6; ++repeat) {
        std::vector<double> times;
        for (const int frame : list_frames()) {
            if ((repeat + frame) % 2 == 0) {
                times.push_back(1e-6 * synthetic::true_ratio(cell) *
                                synthetic::repeat_factor(repeat, 6) *
                                synthetic::anchor_ns(frame, repeat));
            }
        }
        medians[repeat] = compute_median(times);
    }
    return medians;
}

class Analysis : public ::testing::Test {
  protected:
    void SetUp() override { analysis = analyze_run(synthetic::write_run(folder.path(), {})); }
    [[nodiscard]] const CellAnalysis& cell(const std::string& id) const {
        return find_cell(analysis.rounds.at(0), id);
    }

    TemporaryFolder folder;
    RunAnalysis analysis;
};

// The logs of the repeats' ratios are ln k + 0.002 (-2.5, -1.5, ... 2.5): standard deviation 0.002
// sqrt(3.5), and t95(5) = 2.5706, so that half the interval is 2.5706 * 0.0037417 / sqrt(6) =
// 0.0039267 in the logarithm.
constexpr double kHalfWidth = 0.0039267;

TEST_F(Analysis, RatioToTheAnchorWithItsInterval) {
    const Estimate ratio = *cell("hemisphere_ssao").ratio;
    EXPECT_NEAR(ratio.value, 2.5, 1e-6);
    EXPECT_EQ(ratio.n, 6u);
    ASSERT_TRUE(ratio.interval);
    EXPECT_NEAR(ratio.interval->lower, 2.5 * std::exp(-kHalfWidth), 1e-5);
    EXPECT_NEAR(ratio.interval->upper, 2.5 * std::exp(kHalfWidth), 1e-5);
    EXPECT_NEAR(ratio.maximum, 2.5 * std::exp(0.005), 1e-5);
    EXPECT_FALSE(cell("anchor").ratio);
}

TEST_F(Analysis, AAPairGivesTheMinimumDetectableEffect) {
    EXPECT_NEAR(analysis.rounds[0].aa_ratio->value, 1.0, 1e-6);
    EXPECT_NEAR(*analysis.rounds[0].minimum_detectable_effect, std::exp(kHalfWidth) - 1.0, 1e-6);
}

TEST_F(Analysis, TimesAddUpToTheFrame) {
    const CellAnalysis& tssao = cell("tssao");
    EXPECT_NEAR(tssao.input_ms->value, 0.5, 1e-9);
    EXPECT_NEAR(tssao.compose_ms->value, 1.0, 1e-9);
    EXPECT_NEAR(tssao.total_ms->value, 10.0 + 0.5 + tssao.time_ms->value + 1.0, 1e-9);
    EXPECT_EQ(tssao.total_ms->n, 6u);
    std::vector<double> per_repeat;
    for (const auto& [repeat, median] : make_cold_medians_ms("tssao")) {
        per_repeat.push_back(median);
    }
    EXPECT_NEAR(tssao.time_ms->value, compute_mean(per_repeat), 1e-5);
    EXPECT_FALSE(cell("hemisphere_ssao").input_ms);
}

TEST_F(Analysis, ACellWithoutPassesCostsNothingAndHasNoRatio) {
    const CellAnalysis& none = cell("none");
    EXPECT_FALSE(none.ratio);
    EXPECT_FALSE(none.time_ms);
    EXPECT_NEAR(none.total_ms->value, 11.0, 1e-9);
    EXPECT_TRUE(none.is_on_front);
}

TEST_F(Analysis, ConvergedTimesAreTheirOwnOrTheColdOnes) {
    const CellAnalysis& tssao = cell("tssao");
    // Held renderings of a frame are frames of their own: their times are not added up.
    std::vector<double> per_repeat;
    std::vector<double> shares;
    const std::map<int, double> cold = make_cold_medians_ms("tssao");
    for (int repeat = 0; repeat < 6; ++repeat) {
        std::vector<double> ends;
        for (const int frame : {6, 90}) {
            ends.push_back(0.5 * 3e-6 * synthetic::repeat_factor(repeat, 6) *
                           synthetic::anchor_ns(frame, repeat));
        }
        per_repeat.push_back(compute_mean(ends)); // the median of four times one and four the other
        shares.push_back(per_repeat.back() / cold.at(repeat));
    }
    EXPECT_NEAR(tssao.converged_time_ms->value, compute_mean(per_repeat), 1e-5);
    EXPECT_NEAR(tssao.converged_share->value, compute_mean(shares), 1e-5);
    EXPECT_TRUE(tssao.converged_share->interval);
    EXPECT_FALSE(cell("hemisphere_ssao").converged_share);
    EXPECT_EQ(cell("hemisphere_ssao").converged_time_ms->value,
              cell("hemisphere_ssao").time_ms->value);
}

TEST_F(Analysis, PassesExplainTheEnvelope) {
    const CellAnalysis& cell = this->cell("tssao");
    ASSERT_EQ(cell.passes.size(), 4u);
    EXPECT_EQ(cell.passes[0].pass, "input/motion");
    EXPECT_TRUE(cell.passes[0].is_input);
    EXPECT_FALSE(cell.passes[0].is_under_resolution);
    EXPECT_EQ(cell.passes[3].pass, "tssao/clear"); // 30 us, the tick is 1 us
    EXPECT_TRUE(cell.passes[3].is_under_resolution);
    EXPECT_NEAR(cell.passes[3].time_ms.value, 0.03, 1e-9);
    // Divided and undivided frames alternate, so that their contents differ a little.
    EXPECT_NEAR(cell.coverage->value, 1.05 + 0.03 / 14.4, 0.02);
    EXPECT_EQ(cell.coverage->n, 6u);
}

TEST_F(Analysis, ContentAndNoiseAreTwoThings) {
    const CellAnalysis& anchor = cell("anchor");
    EXPECT_EQ(anchor.content->n, 56u); // 3 bursts of 16 and 8 singles
    EXPECT_EQ(anchor.noise->n, 6u);
    std::vector<double>
        medians; // even frames are undivided in repeats 0, 2, 4, odd ones in 1, 3, 5
    for (const int frame : list_frames()) {
        medians.push_back(1e-6 * synthetic::anchor_ns(frame, frame % 2 == 0 ? 2 : 3));
    }
    EXPECT_NEAR(anchor.content->p50_ms, compute_median(medians), 1e-5);
    EXPECT_NEAR(anchor.content->p95_ms, compute_quantile(medians, 0.95), 1e-5);
    // The drift over six repeats: 5 % each around its middle, 1.125.
    EXPECT_NEAR(anchor.noise->p95_ms / anchor.noise->p50_ms, 1.1, 0.05);
}

TEST_F(Analysis, ErrorsOfBurstsAreColdAndOfSinglesConverged) {
    const MetricAnalysis& hemisphere = *cell("hemisphere_ssao").find(SampleState::cold, "rmse");
    EXPECT_EQ(hemisphere.frames, 48u);
    EXPECT_NEAR(hemisphere.shown(), 0.06, 1e-12);
    EXPECT_NEAR(hemisphere.value, std::hypot(0.06, 0.002), 1e-12);
    EXPECT_EQ(cell("hemisphere_ssao").find(SampleState::converged, "rmse")->frames, 8u);

    // 0.003 (1 + 12 * 2^-k) over k = 0..15: the sum of 2^-k is 2 - 2^-15.
    const MetricAnalysis& cold = *cell("tssao").find(SampleState::cold, "rmse");
    EXPECT_NEAR(cold.shown(), 0.003 * (1.0 + 12.0 * (2.0 - std::exp2(-15)) / 16.0), 1e-12);
    EXPECT_FALSE(cold.is_below_floor);
    const MetricAnalysis& converged = *cell("tssao").find(SampleState::converged, "rmse");
    EXPECT_TRUE(converged.is_below_floor);
    EXPECT_EQ(format_error(converged), "< 0.00400");
    EXPECT_FALSE(cell("tssao").find(SampleState::cold, "ssim")->floor);
}

TEST_F(Analysis, MetricsOverTimeAreMeansOverBurstFrames) {
    const RoundAnalysis& round = analysis.rounds[0];
    EXPECT_EQ(round.metrics, (std::vector<std::string>{"rmse", "ssim"}));
    EXPECT_EQ(round.temporal_metrics,
              (std::vector<std::string>{"temporal_flicker", "flicker_ratio", "recovery_frames",
                                        "missed_invalidation"}));
    const MetricAnalysis& flicker = *cell("hemisphere_ssao").find_temporal("temporal_flicker");
    EXPECT_EQ(flicker.frames, 45u); // 3 bursts of 16 without their first frames
    EXPECT_NEAR(flicker.shown(), 0.02, 1e-12);
    EXPECT_NEAR(flicker.value, std::hypot(0.02, 0.001), 1e-12);
    EXPECT_EQ(format_codes(flicker), "5.10");
    EXPECT_EQ(format_codes(*cell("tssao").find_temporal("temporal_flicker")), "< 0.510");
    // 0.001 x the mean of 1..15
    EXPECT_NEAR(cell("tssao").find_temporal("missed_invalidation")->value, 0.008, 1e-12);
    EXPECT_EQ(cell("tssao").find_temporal("recovery_frames")->frames, 3u);
    EXPECT_FALSE(cell("hemisphere_ssao").find_temporal("missed_invalidation"));
    EXPECT_FALSE(cell("hemisphere_ssao").find_temporal("recovery_frames"));
    EXPECT_FALSE(cell("tssao").find(SampleState::cold, "temporal_flicker"));
}

TEST_F(Analysis, NumbersOfHistoriesAreColdOnBurstsAndConvergedOnSingles) {
    EXPECT_EQ(analysis.rounds[0].history_numbers,
              (std::vector<std::string>{"history_invalidated", "history_samples", "history_age"}));
    const MetricAnalysis& cold = *cell("tssao").find_history(SampleState::cold, "history_samples");
    EXPECT_EQ(cold.frames, 48u);
    EXPECT_NEAR(cold.value, (64.0 + 15.0 * 8.0) / 16.0, 1e-12);
    const MetricAnalysis& held =
        *cell("tssao").find_history(SampleState::converged, "history_samples");
    EXPECT_EQ(held.frames, 8u);
    EXPECT_EQ(held.value, synthetic::kConvergedSamples);
    EXPECT_NEAR(cell("tssao").find_history(SampleState::cold, "history_age")->value, 7.5, 1e-12);
    EXPECT_FALSE(cell("tssao").find_history(SampleState::converged, "history_age"));
    EXPECT_FALSE(cell("none").find_history(SampleState::cold, "history_samples"));
}

TEST(AnalysisOfSequences, AMetricOverTimeBelongsToBurstsAlone) {
    const TemporaryFolder folder;
    PlanRecord plan = synthetic::make_plan({.repeats = 1});
    plan.rounds.resize(1);
    RunFolder run = RunFolder::create(folder.path(), synthetic::make_context(), plan);
    std::vector<MetricRow> rows = synthetic::make_metrics(plan.rounds[0]);
    MetricRow stray{"r0-balls", "none", 3,  6, SampleState::cold, "temporal_flicker", 9.0,
                    {},         {},     {}, {}};
    rows.push_back(stray);
    stray.metric = "history_samples";
    rows.push_back(stray);
    run.finish_round("r0-balls", synthetic::make_samples(plan, plan.rounds[0]), rows, {});
    const RunAnalysis analysis = analyze_run(run);
    const CellAnalysis& none = find_cell(analysis.rounds[0], "none");
    EXPECT_EQ(none.find_temporal("temporal_flicker")->frames, 45u);
    EXPECT_FALSE(none.find_history(SampleState::cold, "history_samples"));
    EXPECT_TRUE(std::none_of(none.frame_errors.begin(), none.frame_errors.end(),
                             [](const FrameError& error) { return error.value == 9.0; }));
}

TEST_F(Analysis, TheFrontHoldsWhatNothingBeats) {
    EXPECT_TRUE(cell("hemisphere_ssao").is_on_front);
    EXPECT_TRUE(cell("tssao").is_on_front);
    EXPECT_FALSE(cell("hemisphere_ssao-samples64").is_on_front); // slower and worse than tssao
    EXPECT_FALSE(cell("anchor").is_on_front);
    EXPECT_EQ(
        describe_verdict(analysis.rounds[0]),
        "Not beaten in both time and error: hemisphere_ssao (2.50x the anchor, rmse 0.0600); tssao "
        "(3.00x the anchor, rmse 0.00750).");
}

TEST_F(Analysis, Fitness) {
    EXPECT_TRUE(analysis.is_timer_validated);
    EXPECT_TRUE(analysis.is_complete);
    EXPECT_NEAR(*analysis.rounds[0].reference_floor, synthetic::kRmseFloor, 1e-12);
    EXPECT_NEAR(*analysis.rounds[0].smallest_error, 0.0075, 1e-6);
    EXPECT_NE(describe_device(analysis.context).find("software"), std::string::npos);
}

TEST(AnalysisOfShortRuns, FewRepeatsHaveNoInterval) {
    const TemporaryFolder folder;
    const RunAnalysis analysis = analyze_run(synthetic::write_run(folder.path(), {.repeats = 3}));
    const Estimate ratio = *find_cell(analysis.rounds[0], "hemisphere_ssao").ratio;
    EXPECT_FALSE(ratio.interval);
    EXPECT_EQ(ratio.n, 3u);
    EXPECT_EQ(describe_estimate(ratio), "2.5000 2.4950..2.5050 (n=3)");
}

TEST(AnalysisOfShortRuns, RunsInProgressShowWhatIsFinished) {
    const TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {.finished_rounds = 1});
    const RunAnalysis analysis = analyze_run(
        run, {{"r0-balls", "tssao", "tssao", 3.0}, {"r1-courtyard", "tssao", "tssao", 3.0}});
    EXPECT_FALSE(analysis.is_complete);
    ASSERT_EQ(analysis.rounds.size(), 1u);
    ASSERT_EQ(analysis.provisional.size(), 1u);
    EXPECT_EQ(analysis.provisional[0].round, "r1-courtyard");
}

TEST(AnalysisOfShortRuns, SinglesAloneStandInBothColumnsAndUndefinedValuesAreCounted) {
    const TemporaryFolder folder;
    PlanRecord plan = synthetic::make_plan({.repeats = 1});
    plan.rounds.resize(1);
    plan.rounds[0].segments = {{6, 7}, {9, 10}};
    plan.rounds[0].film = {};
    RunFolder run = RunFolder::create(folder.path(), synthetic::make_context(), plan);
    std::vector<MetricRow> metrics = synthetic::make_metrics(plan.rounds[0]);
    for (MetricRow& row : metrics) {
        if (row.frame == 9) {
            row.value.reset();
            row.note = "equal images";
        }
    }
    run.finish_round("r0-balls", synthetic::make_samples(plan, plan.rounds[0]), metrics, {});
    const RunAnalysis analysis = analyze_run(run);
    const MetricAnalysis& cold =
        *find_cell(analysis.rounds[0], "hemisphere_ssao").find(SampleState::cold, "rmse");
    EXPECT_EQ(cold.frames, 1u);
    EXPECT_EQ(cold.undefined, 1u);
    EXPECT_EQ(cold.note, "equal images");
}

TEST(AnalysisOfShortRuns, ARoundWithoutRowsIsNoAccident) {
    const TemporaryFolder folder;
    RunFolder run =
        RunFolder::create(folder.path(), synthetic::make_context(), synthetic::make_plan({}));
    run.finish_round("r0-balls", {}, {}, {});
    const RunAnalysis analysis = analyze_run(run);
    EXPECT_FALSE(analysis.rounds.at(0).aa_ratio);
    EXPECT_FALSE(find_cell(analysis.rounds[0], "tssao").total_ms);
    EXPECT_EQ(describe_verdict(analysis.rounds[0]), "No method has both a time and an error here.");
}

} // namespace
} // namespace alcove
