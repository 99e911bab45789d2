// Strata in the reports, on rows whose means are known by hand.
#include "reports/analysis/strata.hpp"

#include "reports/csv/strata_csv.hpp"
#include "reports/html/strata_table.hpp"
#include "tests/reports/tradeoff_runs.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr int kWidth = 10;
constexpr int kHeight = 8;

MetricRow make_row(const std::string& cell, int frame, const std::string& metric,
                   std::optional<double> value) {
    MetricRow row;
    row.round = "r1";
    row.cell = cell;
    row.frame = frame;
    row.metric = metric;
    row.value = value;
    row.note = value ? "" : "the mask counts none of the pixels that are pooled";
    return row;
}

PlanRecord make_plan() {
    PlanRecord plan;
    for (const char* name : {"pixels[dark]", "rmse[dark]", "ssim[dark]", "rmse[moving]"}) {
        MetricDescription metric;
        metric.name = name;
        metric.kind = kStratumKind;
        metric.definition = "<all of it>";
        metric.lower_is_better = std::string(name) != "ssim[dark]";
        plan.metrics.push_back(metric);
    }
    return plan;
}

RunAnalysis make_measured() {
    RoundAnalysis round =
        make_round("r1", {make_cell("a", known(1.0, 0.1), "rmse", known(0.3, 0.01)),
                          make_cell("<b>", known(1.0, 0.1), "rmse", known(0.3, 0.01))});
    round.round.width = kWidth;
    round.round.height = kHeight;
    round.round.segments = {{0, 2}};
    std::vector<MetricRow> rows;
    for (const int frame : {0, 1}) {
        rows.push_back(make_row("a", frame, "pixels[dark]", frame == 0 ? 20.0 : 40.0));
        rows.push_back(make_row("a", frame, "rmse[dark]", frame == 0 ? 0.1 : 0.3));
        rows.push_back(make_row("a", frame, "ssim[dark]", 0.5));
        rows.push_back(make_row("a", frame, "rmse[moving]", std::nullopt));
        rows.push_back(make_row("<b>", frame, "rmse[dark]", 0.4));
    }
    RunAnalysis run = make_run({});
    run.plan = make_plan();
    analyze_strata(round, rows, run.plan);
    run.rounds = {round};
    return run;
}

TEST(Strata, ColumnsAreSplitAtTheLastBracket) {
    EXPECT_EQ(split_stratum_column("flip:ppd=30[dark]")->metric, "flip:ppd=30");
    EXPECT_EQ(split_stratum_column("a[b][c]")->metric, "a[b]");
    EXPECT_EQ(split_stratum_column("a[b][c]")->stratum, "c");
    for (const char* name : {"", "rmse", "[dark]", "rmse[", "rmse[]", "rmse[dark"}) {
        EXPECT_FALSE(split_stratum_column(name)) << name;
    }
}

TEST(Strata, AreMeansOverFramesAndKeepTheReasonWhereThereIsNone) {
    const RunAnalysis run = make_measured();
    const RoundAnalysis& round = run.rounds.front();
    const StratumAnalysis* dark = find_stratum(round, "a", SampleState::cold, "rmse", "dark");
    ASSERT_NE(dark, nullptr);
    EXPECT_NEAR(dark->value.value, 0.2, 1e-12);
    EXPECT_EQ(dark->value.frames, 2u);
    const StratumAnalysis* moving = find_stratum(round, "a", SampleState::cold, "rmse", "moving");
    ASSERT_NE(moving, nullptr);
    EXPECT_EQ(moving->value.frames, 0u);
    EXPECT_NE(moving->value.note.find("mask"), std::string::npos);
    EXPECT_EQ(find_stratum(round, "<b>", SampleState::cold, "ssim", "dark"), nullptr);
    EXPECT_EQ(list_stratum_metrics(round), (std::vector<std::string>{"rmse", "ssim"}));
    EXPECT_EQ(list_stratum_names(round), (std::vector<std::string>{"dark", "moving"}));
}

TEST(Strata, TheCsvTellsPixelsCountedAndIgnored) {
    const std::string text = make_strata_csv(make_measured());
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5) << text;
    EXPECT_NE(text.find("rmse,dark,0.2,,,2,0,30,50,"), std::string::npos) << text;
    EXPECT_EQ(text.find("pixels,dark"), std::string::npos);
    const std::string empty = make_strata_csv(make_run({make_round("r2", {})}));
    EXPECT_EQ(std::count(empty.begin(), empty.end(), '\n'), 1);
}

TEST(Strata, TheTableMarksTheBestAndEscapesWhatItShows) {
    const RunAnalysis run = make_measured();
    const std::string table = make_strata_tables(run, run.rounds.front());
    EXPECT_NE(table.find("By part of the frame"), std::string::npos);
    EXPECT_NE(table.find("30 px, 37.5 % of a frame"), std::string::npos) << table;
    EXPECT_EQ(table.find("<b>:"), std::string::npos);
    EXPECT_NE(table.find("&lt;b&gt;"), std::string::npos);
    EXPECT_EQ(table.find("<all of it>"), std::string::npos);
    EXPECT_NE(table.find("class=\"best\" data-value=\"0.2\""), std::string::npos) << table;
    EXPECT_TRUE(make_strata_tables(run, make_round("r2", {})).empty());
}

} // namespace
} // namespace alcove
