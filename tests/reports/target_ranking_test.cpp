// Places under targets, on errors that stand in the test.
#include "reports/analysis/target_ranking.hpp"

#include "reports/csv/target_csv.hpp"
#include "reports/html/target_section.hpp"
#include "tests/reports/tradeoff_runs.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace alcove {
namespace {

CellAnalysis make(const std::string& label, double rmse, const std::string& settings = "common") {
    CellAnalysis cell = make_cell(label, known(1.0, 0.1), "rmse", known(rmse, 0.001));
    cell.cell.settings = settings;
    return cell;
}

RoundAnalysis make_target_round(const std::string& id, const std::string& target,
                                std::vector<CellAnalysis> cells) {
    RoundAnalysis round = make_round(id, std::move(cells));
    round.round.target = target;
    return round;
}

/// a before b under hard falloff, b before a under linear; c is last under both.
RunAnalysis make_two_targets() {
    return make_run(
        {make_target_round("r1", "falloff=none", {make("a", 0.1), make("b", 0.2), make("c", 0.3)}),
         make_target_round("r2", "falloff=linear",
                           {make("a", 0.2), make("b", 0.1), make("c", 0.3)})});
}

TEST(TargetRanking, TellsWhosePlaceChanges) {
    const std::vector<TargetRanking> rankings = rank_targets(make_two_targets());
    ASSERT_EQ(rankings.size(), 1u);
    ASSERT_EQ(rankings[0].targets.size(), 2u);
    EXPECT_EQ(rankings[0].targets[0].cells[0].label, "a");
    EXPECT_EQ(rankings[0].targets[1].cells[0].label, "b");
    EXPECT_EQ(rankings[0].targets[1].cells[2].place, 3u);
    EXPECT_EQ(rankings[0].moved, (Labels{"a", "b"}));
}

TEST(TargetRanking, OneTargetWithCommonSettingsHasNothingToTell) {
    EXPECT_TRUE(rank_targets(make_run({make_target_round("r1", "falloff=none", {make("a", 0.1)})}))
                    .empty());
}

TEST(TargetRanking, NativeSettingsHaveNoPlaceHoweverGoodTheyAre) {
    const std::vector<TargetRanking> rankings = rank_targets(
        make_run({make_target_round("r1", "falloff=none",
                                    {make("a (native)", 0.01, "native"), make("a", 0.2),
                                     make("a tuned", 0.1, "calibrated")})}));
    ASSERT_EQ(rankings.size(), 1u);
    const std::vector<RankedCell>& cells = rankings[0].targets[0].cells;
    EXPECT_EQ(cells[0].label, "a tuned");
    EXPECT_EQ(cells[0].place, 1u);
    EXPECT_EQ(cells[1].place, 2u);
    EXPECT_EQ(cells[2].label, "a (native)");
    EXPECT_FALSE(cells[2].place);
}

TEST(TargetRanking, ErrorsUnderTheReferencesFloorShareAPlace) {
    RunAnalysis run = make_two_targets();
    for (CellAnalysis& cell : run.rounds[0].cells) {
        // 0.1 and 0.2 lie under a floor of 0.25.
        cell.cold[0].floor = 0.25;
        cell.cold[0].is_below_floor = cell.cold[0].value < 0.25;
    }
    const RankedTarget first = rank_targets(run).at(0).targets[0];
    EXPECT_EQ(first.cells[0].place, 1u);
    EXPECT_EQ(first.cells[1].place, 1u);
    EXPECT_EQ(first.cells[2].place, 3u);
}

TEST(TargetRanking, OtherSizesAreAnotherRanking) {
    RunAnalysis run = make_two_targets();
    run.rounds[1].round.width = 128;
    EXPECT_TRUE(rank_targets(run).empty()) << "each has one target";
}

TEST(TargetRanking, NativeCellsAreNeitherOnTheFrontNorTheBest) {
    CellAnalysis cell = make("a", 0.1, "native");
    EXPECT_FALSE(is_compared(cell));
    cell.cell.settings = "calibrated";
    EXPECT_TRUE(is_compared(cell));
    cell.cell.role = CellRole::anchor;
    EXPECT_FALSE(is_compared(cell));
}

TEST(TargetRanking, TheCsvHasALineForEachCellAndTarget) {
    const std::string text = make_target_csv(make_two_targets());
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
    EXPECT_NE(text.find(",falloff=linear,r2,b,b,common,rmse,cold,0.1,"), std::string::npos) << text;
}

TEST(TargetRanking, TheSectionSaysWhoMovesAndEscapesLabels) {
    RunAnalysis run = make_two_targets();
    for (RoundAnalysis& round : run.rounds) {
        round.cells[0].cell.label = "<script>a";
        round.cells[2].cell.target_note = "cannot do <falloff>";
    }
    const std::string page = make_target_section(run);
    EXPECT_NE(page.find("2 of 3 change place"), std::string::npos);
    EXPECT_EQ(page.find("<script>"), std::string::npos);
    EXPECT_NE(page.find("cannot do &lt;falloff&gt;"), std::string::npos);
}

} // namespace
} // namespace alcove
