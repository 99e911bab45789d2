// A round whose errors are taken apart: every single frame, both marches, steps that close, and
// curves that never make it worse.
#include "harness/run/error_explainer.hpp"
#include "tests/harness/round_runner_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace alcove {
namespace {

class ErrorExplainerTest : public RoundRunnerTest {
  protected:
    ErrorExplainerTest() { m_explains_errors = true; }

    std::vector<StepRecord> find_steps(const std::string& cell, bool infinite) const {
        std::vector<StepRecord> steps;
        for (const StepRecord& record : m_result.done.steps) {
            if (record.cell == cell && std::isinf(record.thickness) == infinite) {
                steps.push_back(record);
            }
        }
        return steps;
    }
    bool has_picture(const std::string& cell, int frame, const std::string& picture) const {
        return std::filesystem::exists(
            m_folder.path() / RunFolder::make_image_path(round().id, cell, frame, picture));
    }
};

TEST_F(ErrorExplainerTest, StepsOfEverySingleCloseOverBothMarches) {
    run({"hemisphere_ssao", "none", "reference_brute_force"}, 1);
    for (std::size_t method = 0; method < 3; ++method) {
        for (const bool infinite : {true, false}) {
            const std::vector<StepRecord> steps = find_steps(cell(method).id, infinite);
            ASSERT_EQ(steps.size(), 3u) << cell(method).label;
            for (const StepRecord& s : steps) {
                EXPECT_EQ(s.has_converged_form, method == 0);
                EXPECT_NEAR(s.total, s.d1 + s.d2 + s.d3 + 2.0 * (s.d1_d2 + s.d1_d3 + s.d2_d3),
                            1e-12);
                EXPECT_GT(s.truth_noise, 0.0);
                EXPECT_GT(s.march_noise, 0.0);
            }
        }
    }
    // Samples and blur of the 16-sample method are an error of their own.
    EXPECT_GT(find_steps(cell(0).id, true)[0].d1, 1e-6);
    // The march as a method differs from the march only by its noise.
    for (const StepRecord& s : find_steps(cell(2).id, true)) {
        EXPECT_LT(s.d2, 6.0 * s.march_noise);
    }
    // `none` knows nothing: all that screen space could tell is missing.
    for (const StepRecord& s : find_steps(cell(1).id, true)) {
        EXPECT_GT(s.d2, s.d3);
    }
}

TEST_F(ErrorExplainerTest, TheTotalIsTheErrorThatTheMetricMeasured) {
    run({"hemisphere_ssao"}, 1);
    const std::vector<StepRecord> steps = find_steps(cell(0).id, true);
    int compared = 0;
    for (const MetricRow& row : m_result.metrics) {
        for (const StepRecord& s : steps) {
            if (row.metric == "mse" && row.segment == s.segment && row.frame == s.frame) {
                EXPECT_NEAR(row.value.value(), s.total, 1e-9) << row.frame;
                ++compared;
            }
        }
    }
    EXPECT_EQ(compared, 3);
}

TEST_F(ErrorExplainerTest, TheBestThicknessHasTheLeastErrorOfTheFiniteOnes) {
    run({"none"}, 1);
    const std::vector<ThicknessRecord>& tried = m_result.done.thicknesses;
    ASSERT_EQ(tried.size(), kThicknesses.size() + 1);
    EXPECT_TRUE(std::isinf(tried.back().thickness));
    int best = 0;
    for (const ThicknessRecord& record : tried) {
        best += record.is_best ? 1 : 0;
        for (const ThicknessRecord& other : tried) {
            if (record.is_best && std::isfinite(other.thickness)) {
                EXPECT_LE(record.mse, other.mse);
            }
        }
    }
    EXPECT_EQ(best, 1);
}

TEST_F(ErrorExplainerTest, ACurveNeverAddsErrorWhereItWasFitted) {
    run({"hemisphere_ssao:strength=2", "hemisphere_ssao"}, 1);
    ASSERT_EQ(m_result.done.curves.size(), 2u);
    for (const CurveRecord& curve : m_result.done.curves) {
        EXPECT_EQ(curve.frames, 3);
        EXPECT_LE(curve.mse_fitted, curve.mse + 1e-6);
        EXPECT_GE(curve.mse_held_out, curve.mse_fitted - 1e-9);
        EXPECT_TRUE(std::is_sorted(curve.curved.begin(), curve.curved.end()));
    }
    // Doubled strength is what a slider mends: most of its error goes, held out as well.
    const CurveRecord& doubled = m_result.done.curves[0];
    EXPECT_LT(doubled.mse_held_out, 0.6 * doubled.mse);
}

TEST_F(ErrorExplainerTest, PicturesOfTheStepsAreKept) {
    run({"hemisphere_ssao", "none"}, 1);
    const int frame = round().image_frames.front();
    for (const char* picture : {"step1", "step2_infinite", "step2_best"}) {
        EXPECT_TRUE(has_picture(cell(0).id, frame, picture)) << picture;
    }
    EXPECT_FALSE(has_picture(cell(1).id, frame, "step1")) << "none has no converged form";
    EXPECT_TRUE(has_picture("reference", frame, "step3_infinite"));
    EXPECT_TRUE(has_picture("reference", frame, "step3_best"));
}

TEST_F(ErrorExplainerTest, NothingIsExplainedUnasked) {
    m_explains_errors = false;
    run({"none"}, 1);
    EXPECT_TRUE(m_result.done.steps.empty());
    EXPECT_TRUE(m_result.done.curves.empty());
    EXPECT_EQ(m_result.done.explaining_s, 0.0);
}

} // namespace
} // namespace alcove
