// `alcove recommend` over a small run of the built program.

#include "tests/harness/program.hpp"

namespace alcove {
namespace {

class RecommendVerb : public ProgramTest {
  protected:
    static void SetUpTestSuite() {
        ProgramTest::SetUpTestSuite();
        const ChildResult result =
            run({"run", "--scene", "template_scene", "--size", "64x48", "--frames", "0:4",
                 "--repeat", "5", "--method", "none", "--method", "hemisphere_ssao", "--method",
                 "hemisphere_ssao:samples=4", "--out", "small"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    static void expect_answer(const char* quality, std::initializer_list<const char*> parts) {
        const ChildResult result = run({"recommend", "small", "--quality", quality});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        for (const char* part : parts) {
            EXPECT_NE(result.out.find(part), std::string::npos)
                << "`" << part << "` is missing in: " << result.out;
        }
    }
};

TEST_F(RecommendVerb, AQualityThatAllHaveIsGivenByTheCellThatCostsNothing) {
    expect_answer("RMSE<2", {"template_scene 64x48", ": none: no passes, rmse ", "software"});
    expect_answer("ssim>-2", {": none: no passes, ssim "});
}

TEST_F(RecommendVerb, AQualityThatNothingHasNamesTheMostAccurate) {
    expect_answer("rmse<0",
                  {"nothing that ran has this quality; most accurate is hemisphere_ssao"});
}

TEST_F(RecommendVerb, WhatCannotBeAnsweredIsRefused) {
    expect_refused({"recommend", "small", "--quality", "rmsee<0.1"}, 2,
                   {"--quality", "nearest: rmse"});
    expect_refused({"recommend", "small", "--quality", "rmse>0.1"}, 2,
                   {"--quality", "rmse<NUMBER"});
    expect_refused({"recommend", "small", "--quality", "good"}, 2, {"--quality", "good"});
    expect_refused({"recommend", "small", "--budget", "5"}, 2, {"--budget", "software"});
    expect_refused({"recommend", "small"}, 2, {"--quality", "--budget"});
    expect_refused({"recommend", "small", "--quality", "rmse<0.1", "--budget", "5"}, 2,
                   {"--quality", "--budget"});
    expect_refused({"recommend", "nowhere", "--quality", "rmse<0.1"}, 2, {"nowhere"});
}

} // namespace
} // namespace alcove
