// What tuning tells people: gaps, curves and labels that are not trusted.
#include "reports/csv/tune_csv.hpp"
#include "reports/html/tune_page.hpp"
#include "reports/record/tune_record.hpp"
#include "reports/terminal/tune_table.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace alcove {
namespace {

TuneJudgementRecord make_judgement(std::string_view set, double before, double after) {
    TuneJudgementRecord judgement;
    judgement.set = set;
    judgement.metric = "rmse";
    judgement.is_objective = true;
    judgement.frames = 4;
    judgement.before = before;
    judgement.after = after;
    judgement.change = after - before;
    judgement.lower = judgement.change - 0.01;
    judgement.upper = judgement.change + 0.01;
    return judgement;
}

TuneRecord make_record() {
    TuneRecord record;
    record.objective = "rmse";
    record.judge = "ssim";
    TunedMethodRecord method;
    method.id = "m";
    method.label = "<script>m";
    method.method = "m";
    method.preset = "default";
    method.evaluations = 3;
    method.parameters = {{"radius", "r", "1.5 * scene_radius", 1.2, 1.3}};
    method.history = {{0, "grid", {"1 * scene_radius"}, 0.4},
                      {0, "search", {"1.5 * scene_radius"}, 0.2},
                      {0, "search", {"2 * scene_radius"}, 0.3},
                      {1, "grid", {"1.5 * scene_radius"}, 0.2}};
    method.least_costs = {0.2, 0.2};
    method.is_converged = true;
    method.judgements = {make_judgement(kTrainingSet, 0.4, 0.2),
                         make_judgement("held-out frames", 0.4, 0.25),
                         make_judgement("held-out scenes", 0.4, 0.45)};
    method.calibration = "m/preset.toml";
    record.methods = {method};
    return record;
}

TEST(TuneReport, TheGapIsTheShareOfTheGainThatIsLost) {
    const TunedMethodRecord method = make_record().methods[0];
    EXPECT_FALSE(find_generalisation_gap(method, method.judgements[0]));
    EXPECT_NEAR(find_generalisation_gap(method, method.judgements[1]).value(), 0.25, 1e-12);
    // Worse than before: more than all of it is lost.
    EXPECT_NEAR(find_generalisation_gap(method, method.judgements[2]).value(), 1.25, 1e-12);
}

TEST(TuneReport, TheCsvFollowsTheLeastCostOfEachAttempt) {
    const std::string text = make_tune_csv(make_record());
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
    EXPECT_NE(text.find("3,search,radius=2 * scene_radius,0.3,0.2"), std::string::npos) << text;
    const std::string judged = make_judgements_csv(make_record());
    EXPECT_EQ(std::count(judged.begin(), judged.end(), '\n'), 4);
}

TEST(TuneReport, ThePageEscapesAndSaysHowItEnded) {
    TuneRecord record = make_record();
    EXPECT_NE(make_tune_page(record).find("Converged: two attempts end at 0.2000 and 0.2000"),
              std::string::npos);
    record.methods[0].is_converged = false;
    const std::string page = make_tune_page(record);
    EXPECT_NE(page.find("Not converged"), std::string::npos);
    EXPECT_EQ(page.find("<script>"), std::string::npos);
    EXPECT_NE(page.find("<polyline"), std::string::npos);
    EXPECT_NE(make_tune_table(record).find("NOT CONVERGED"), std::string::npos);
}

} // namespace
} // namespace alcove
