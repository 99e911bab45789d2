// Which cell is taken for a quality.

#include "core/base/error.hpp"
#include "reports/analysis/recommendation.hpp"
#include "tests/reports/tradeoff_runs.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

std::vector<Recommendation> ask(const RunAnalysis& run, const char* quality) {
    return recommend(run, parse_quality(quality, run.plan));
}

std::string tell(const RunAnalysis& run, const char* quality) {
    return describe_recommendation(ask(run, quality).at(0), parse_quality(quality, run.plan));
}

TEST(Recommend, TheFastestThatSurelyHasTheQualityIsDecided) {
    const RunAnalysis run = make_simple_run(0.01);
    const Recommendation decided = ask(run, "RMSE<0.05").at(0);
    EXPECT_EQ(list_labels(decided.cells), Labels{"a:n=4"});
    EXPECT_TRUE(decided.uncertain.empty());
    EXPECT_EQ(decided.most_accurate.label, "slow");
    EXPECT_EQ(tell(run, "RMSE<0.05"), "hall 64x48, radius=1 m: a:n=4: 4.000 [3.960, 4.040] (n=6) x "
                                      "anchor, rmse 0.02000 [0.01980, 0.02020] (n=6)");
}

TEST(Recommend, TimesThatAreNotToldApartAreAllNamed) {
    const RunAnalysis run = make_simple_run(0.15);
    EXPECT_EQ(list_labels(ask(run, "rmse<0.05").at(0).cells), (Labels{"a:n=4", "b"}));
    EXPECT_NE(tell(run, "rmse<0.05").find("cannot decide between\n  a:n=4"), std::string::npos);
}

TEST(Recommend, AFasterCellWhoseIntervalHoldsTheBoundIsUncertain) {
    const RunAnalysis run = make_simple_run(0.1);
    const Recommendation uncertain = ask(run, "rmse<0.076").at(0);
    EXPECT_EQ(list_labels(uncertain.cells), Labels{"a:n=4"}) << "b is told apart by its time";
    EXPECT_EQ(list_labels(uncertain.uncertain), Labels{"a:n=1"});
    EXPECT_NE(tell(run, "rmse<0.076").find("faster, and perhaps: a:n=1"), std::string::npos);
    // The slowest alone may have it.
    const Recommendation perhaps = ask(run, "rmse<0.0105").at(0);
    EXPECT_TRUE(perhaps.cells.empty());
    EXPECT_EQ(list_labels(perhaps.uncertain), Labels{"slow"});
    EXPECT_NE(tell(run, "rmse<0.0105").find("no cell surely has"), std::string::npos);
}

TEST(Recommend, NothingHasIt) {
    const RunAnalysis run = make_simple_run(0.01);
    const Recommendation nothing = ask(run, "rmse<0.001").at(0);
    EXPECT_TRUE(nothing.cells.empty());
    EXPECT_TRUE(nothing.uncertain.empty());
    EXPECT_NE(
        tell(run, "rmse<0.001").find("nothing that ran has this quality; most accurate is slow"),
        std::string::npos);
}

TEST(Recommend, HigherIsBetterIsAskedForFromAbove) {
    const RunAnalysis run =
        make_run({make_round("r0", {make_cell("a", known(1.0, 0.01), "ssim", known(0.80, 0.01)),
                                    make_cell("b", known(2.0, 0.01), "ssim", known(0.95, 0.01))})});
    EXPECT_EQ(list_labels(ask(run, "SSIM>0.9").at(0).cells), Labels{"b"});
    EXPECT_EQ(ask(run, "SSIM>0.9").at(0).most_accurate.label, "b");
    EXPECT_EQ(list_labels(ask(run, "ssim>0.805").at(0).uncertain), Labels{"a"});
}

TEST(Recommend, QualitiesThatMeanNothingAreRefused) {
    const PlanRecord plan = make_simple_run(0.01).plan;
    const auto refuse = [&](const char* text) -> std::string {
        try {
            (void)parse_quality(text, plan);
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_NE(refuse("rmsee<0.05").find("nearest: rmse"), std::string::npos);
    EXPECT_NE(refuse("rmse>0.05").find("rmse<NUMBER"), std::string::npos);
    EXPECT_NE(refuse("ssim<0.9").find("ssim>NUMBER"), std::string::npos);
    for (const char* garbage : {"", "rmse", "<0.05", "rmse<", "rmse<x", "rmse<0.05x", "rmse<nan",
                                "rmse<inf", "rmse<<0.05", "rmse=0.05"}) {
        EXPECT_NE(refuse(garbage).find("--quality"), std::string::npos) << garbage;
    }
}

} // namespace
} // namespace alcove
