// The runner: a cell for every method and case, deterministic, with pictures of what failed.
#include "core/base/error.hpp"
#include "harness/stability/image_checks.hpp"
#include "harness/stability/run_stability.hpp"
#include "harness/stability/stability_cases.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/stability/planted_method.hpp"

#include <limits>

namespace alcove {
namespace {

class RunStability : public GlTest {
  protected:
    static StabilityPlan make_plan(std::vector<std::string> cases) {
        StabilityPlan plan;
        plan.methods = {parse_method_spec("planted"), parse_method_spec("planted:radius=2#again")};
        plan.cases = choose_cases(cases);
        plan.size = {48, 36};
        return plan;
    }
    static Registry<MethodUnit> make_registry() {
        return {"methods", {make_planted_unit([](const PlantedFrame& frame, Image& visibility) {
                    darken_surfaces(frame, visibility,
                                    frame.view.camera.fov_y_radians > 2.0 ? 0.5f : 1.0f);
                })}};
    }
};

TEST_F(RunStability, EveryMethodHasACellInEveryCase) {
    std::vector<std::string> pictures;
    StabilityEvents events;
    events.picture = [&](const StabilityPicture& picture) { pictures.push_back(picture.path); };
    const StabilityRecord record =
        run_stability(make_plan({"fov_wide", "fov_narrow"}), context(), make_registry(), events);
    ASSERT_EQ(record.cells.size(), 4u);
    EXPECT_EQ(find_cell(record, "fov_narrow", "again").outcome, StabilityOutcome::holds);
    const StabilityCellRecord& wide = find_cell(record, "fov_wide", "planted");
    EXPECT_EQ(wide.outcome, StabilityOutcome::holds_up_to);
    EXPECT_EQ(judge(wide.scores).held, 2u) << "60 and 90 degrees hold, 120 does not";
    EXPECT_EQ(count_failures(record), 2u);
    ASSERT_EQ(pictures.size(), 4u) << "mild and harsh, of both";
    EXPECT_EQ(wide.scores.front().picture, pictures.front());
    EXPECT_EQ(record.methods[1].overrides.at(0).value, "2");
}

TEST_F(RunStability, TwiceIsTheSame) {
    const StabilityPlan plan = make_plan({"size_odd", "sky_edges"});
    const StabilityRecord first = run_stability(plan, context(), make_registry(), {});
    const StabilityRecord second = run_stability(plan, context(), make_registry(), {});
    for (std::size_t i = 0; i < first.cells.size(); ++i) {
        for (std::size_t s = 0; s < first.cells[i].scores.size(); ++s) {
            EXPECT_EQ(first.cells[i].scores[s].score, second.cells[i].scores[s].score);
        }
    }
}

TEST_F(RunStability, RefusesWhatIsUnknownOrStandsTwice) {
    EXPECT_THROW(static_cast<void>(choose_cases(std::vector<std::string>{"fov_wid"})), InputError);
    StabilityPlan plan = make_plan({"fov_wide"});
    plan.methods.push_back(plan.methods.front());
    EXPECT_THROW(static_cast<void>(run_stability(plan, context(), make_registry(), {})),
                 InputError);
    plan.methods = {parse_method_spec("planted:radius=-1")};
    EXPECT_THROW(static_cast<void>(run_stability(plan, context(), make_registry(), {})),
                 InputError);
}

TEST(ImageChecks, FaultsAreFoundWithTheirPlace) {
    Image depth({3, 2}, 1, 1.0f);
    depth.at(2, 1) = std::numeric_limits<float>::infinity();
    Image visibility({3, 2}, 1, 1.0f);
    EXPECT_EQ(find_fault(visibility, depth), "");
    visibility.at(2, 1) = 0.99999994f; // one step below 1
    EXPECT_NE(find_fault(visibility, depth).find("background"), std::string::npos);
    EXPECT_NE(find_fault(visibility, depth).find("(2, 1)"), std::string::npos);
    visibility.at(1, 0) = 1.0000001f;
    EXPECT_NE(find_fault(visibility, depth).find("outside [0,1]"), std::string::npos);
    visibility.at(0, 0) = -std::numeric_limits<float>::infinity();
    EXPECT_NE(find_fault(visibility, depth).find("not finite"), std::string::npos);
}

TEST(ImageChecks, NumbersAreThoseDoneByHand) {
    const Image zero({4, 2}, 1);
    Image image({4, 2}, 1);
    Image mask({4, 2}, 1);
    for (int y = 0; y < 2; ++y) {
        image.at(0, y) = 0.2f; // left column
        mask.at(0, y) = 1.0f;
        mask.at(1, y) = 1.0f;
    }
    EXPECT_NEAR(compute_rms_codes(image, zero), 255.0 * 0.1, 1e-4); // sqrt(2 * 0.04 / 8)
    EXPECT_NEAR(compute_mean_codes(image, zero, mask), 255.0 * 0.1, 1e-4);
    // Left half: mean 0.1; right half: not on the mask.
    EXPECT_NEAR(compute_worst_block_codes(image, zero, mask, {2, 1}), 255.0 * 0.1, 1e-4);
}

} // namespace
} // namespace alcove
