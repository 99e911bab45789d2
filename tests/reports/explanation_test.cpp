// Steps and curves in the reports, on moments that add up by hand.
#include "reports/analysis/explanation.hpp"

#include "reports/csv/explanation_csv.hpp"
#include "reports/html/explanation_block.hpp"
#include "reports/record/record_json.hpp"
#include "tests/reports/tradeoff_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

StepRecord make_steps(const std::string& cell, int frame, double thickness, double d1) {
    StepRecord steps;
    steps.cell = cell;
    steps.frame = frame;
    steps.thickness = thickness;
    steps.has_converged_form = true;
    steps.d1 = d1 * d1;
    steps.d2 = 0.04;
    steps.d1_d2 = 0.2 * d1;
    steps.total = (d1 + 0.2) * (d1 + 0.2);
    return steps;
}

RoundAnalysis make_explained() {
    RoundAnalysis round =
        make_round("r1", {make_cell("a", known(1.0, 0.1), "rmse", known(0.3, 0.01)),
                          make_cell("<b>", known(1.0, 0.1), "rmse", known(0.3, 0.01))});
    round.done.thicknesses = {{0.5, 0.02, true}, {kInfinite, 0.03, false}};
    for (const char* cell : {"a", "<b>"}) {
        for (const int frame : {3, 5}) {
            round.done.steps.push_back(make_steps(cell, frame, kInfinite, frame == 3 ? 0.1 : 0.3));
            round.done.steps.push_back(make_steps(cell, frame, 0.5, 0.1));
        }
    }
    round.done.curves.push_back({"a", 2, 0.09, 0.01, 0.04, {0.0, 1.0}, {0.2, 0.9}});
    round.done.curves.push_back({"<b>", 1, 0.09, 0.01, std::nan(""), {0.0, 1.0}, {0.2, 0.9}});
    return round;
}

TEST(Explanation, MomentsAreMeansOverFramesAndClose) {
    const std::vector<ExplainedError> explained = explain_errors(make_explained());
    ASSERT_EQ(explained.size(), 4u);
    EXPECT_EQ(explained[0].label, "a");
    EXPECT_TRUE(std::isinf(explained[0].thickness));
    EXPECT_EQ(explained[0].frames, 2u);
    EXPECT_NEAR(explained[0].mean.d1, 0.05, 1e-12);    // (0.01 + 0.09) / 2
    EXPECT_NEAR(explained[0].mean.total, 0.17, 1e-12); // (0.09 + 0.25) / 2
    EXPECT_NEAR(explained[0].closure, 0.0, 1e-12);
    EXPECT_EQ(explained[1].thickness, 0.5);
    EXPECT_NEAR(explained[1].mean.total, 0.09, 1e-12);
}

TEST(Explanation, CurvesAreToldAsRootsAndASingleFrameHoldsNothingOut) {
    const std::vector<CurveAnalysis> curves = analyze_curves(make_explained());
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_NEAR(curves[0].rmse, 0.3, 1e-12);
    EXPECT_NEAR(curves[0].rmse_fitted, 0.1, 1e-12);
    EXPECT_NEAR(curves[0].rmse_held_out.value(), 0.2, 1e-12);
    EXPECT_FALSE(curves[1].rmse_held_out);
}

TEST(Explanation, TheBlockHoldsTablesAndEscapesLabels) {
    const RoundAnalysis round = make_explained();
    const PictureFinder finder("run", "run/report");
    const std::string block = make_explanation_block(round, finder);
    EXPECT_NE(block.find("Errors in steps"), std::string::npos);
    EXPECT_NE(block.find("0.500 r: 20000 (best)"), std::string::npos) << block;
    EXPECT_NE(block.find("<svg"), std::string::npos);
    EXPECT_EQ(block.find("<b>\"<"), std::string::npos);
    EXPECT_EQ(block.find(">\"<b>"), std::string::npos);
    EXPECT_NE(block.find("&lt;b&gt;"), std::string::npos);
    EXPECT_TRUE(make_explanation_block(make_round("r2", {}), finder).empty());
}

TEST(Explanation, TheCsvHasALineForEachCellFrameAndMarch) {
    RunAnalysis run = make_run({make_explained()});
    const std::string text = make_explanation_csv(run);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 9);
    EXPECT_NE(text.find(",inf,1,"), std::string::npos) << text;
}

TEST(Explanation, StepsAndCurvesSurviveTheRoundsFile) {
    const RoundDone done = make_explained().done;
    const RoundDone read = parse_done_json(make_json(done), "done.json");
    ASSERT_EQ(read.steps.size(), done.steps.size());
    EXPECT_TRUE(std::isinf(read.steps[0].thickness));
    EXPECT_EQ(read.steps[0].total, done.steps[0].total);
    EXPECT_TRUE(read.thicknesses[0].is_best);
    EXPECT_EQ(read.curves[0].curved, done.curves[0].curved);
    EXPECT_TRUE(std::isnan(read.curves[1].mse_held_out));
}

} // namespace
} // namespace alcove
