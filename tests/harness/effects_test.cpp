#include "harness/run/effects_saving.hpp"

#include "harness/run/effects_planner.hpp"
#include "harness/run/plan.hpp"
#include "harness/run/scene_source.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <algorithm>

namespace alcove {
namespace {

bool is_needed(const std::vector<EffectRecord>& decisions, const std::string& effect) {
    const auto found =
        std::find_if(decisions.begin(), decisions.end(),
                     [&effect](const EffectRecord& decision) { return decision.effect == effect; });
    return found != decisions.end() && found->is_needed;
}

std::vector<EffectRecord> plan(const std::string& spec, std::vector<SegmentRecord> segments,
                               bool bounce = false) {
    std::vector<std::string> warnings;
    return plan_effects(*open_scene(get_units().scenes, spec, warnings), segments, bounce);
}

TEST(EffectsPlanner, ACameraThatMovesNeedsReprojectionAndNoMotion) {
    const std::vector<EffectRecord> decisions = plan("template_scene", {{0, 8}});
    EXPECT_FALSE(is_needed(decisions, "object_motion"));
    EXPECT_TRUE(is_needed(decisions, "reprojection"));
    EXPECT_FALSE(is_needed(decisions, "light_buffers"));
    EXPECT_EQ(describe(choose_effects(decisions)), "without object_motion,light_buffers");
}

TEST(EffectsPlanner, OnlyReplayedFramesCount) {
    // The box moves from frame 58 on, the camera never.
    const std::vector<EffectRecord> before = plan("lifted_box", {{0, 50}, {100, 101}});
    EXPECT_FALSE(is_needed(before, "object_motion"));
    EXPECT_FALSE(is_needed(before, "reprojection"));
    EXPECT_NE(before.at(0).evidence.find("none of 49 frames"), std::string::npos)
        << before.at(0).evidence;
    const std::vector<EffectRecord> while_moving = plan("lifted_box", {{50, 70}});
    EXPECT_TRUE(is_needed(while_moving, "object_motion"));
    EXPECT_TRUE(is_needed(while_moving, "reprojection"));
    EXPECT_NE(while_moving.at(0).evidence.find("first on frame 5"), std::string::npos)
        << while_moving.at(0).evidence;
    // The first frame of a segment has nothing before it.
    EXPECT_FALSE(is_needed(plan("lifted_box", {{60, 61}}), "reprojection"));
}

TEST(EffectsPlanner, ABounceNeedsLight) {
    EXPECT_TRUE(is_needed(plan("template_scene", {{0, 8}}, true), "light_buffers"));
}

class PlannedImages : public GlTest {
  protected:
    PlannedImages() : m_cache("ALCOVE_CACHE", (m_folder.path() / "cache").string()) {}

    /// Largest difference between the planned and the full image of every cell.
    std::vector<SavingRecord> measure(const std::string& scene_spec, const std::string& frames,
                                      const std::vector<std::string>& methods) {
        const Units units = get_units();
        Experiment experiment;
        experiment.scenes = {{scene_spec, std::nullopt}};
        experiment.frames = {FrameChoice::Kind::ranges, {frames}};
        experiment.sizes = {{96, 72}};
        experiment.effects = EffectsChoice::automatic;
        for (const std::string& method : methods) {
            experiment.methods.push_back(parse_method_spec(method));
        }
        const PlanRecord record = make_plan(experiment, units).record;
        std::vector<std::string> warnings;
        const std::unique_ptr<Scene> scene = open_scene(units.scenes, scene_spec, warnings);
        m_round = record.rounds.at(0);
        return measure_savings(context(), gl::TimerMode::fenced_wall, units, record, m_round,
                               *scene);
    }

    TemporaryFolder m_folder;
    ScopedVariable m_cache;
    RoundRecord m_round;
};

const std::vector<std::string> kMethods{"hemisphere_ssao",
                                        "tssao",
                                        "tssao:packing=packed",
                                        "tssao:packing=separate",
                                        "tssao:resolution=half,guard=5",
                                        "tssao@paper_table2_vienna",
                                        "tssao:history_cap=40"};

TEST_F(PlannedImages, StayWithinOneCodeWhereNothingMoves) {
    for (const char* spec : {"lifted_box", "bunny:turn=1"}) {
        SCOPED_TRACE(spec);
        const std::vector<SavingRecord> savings = measure(spec, "0:8", kMethods);
        ASSERT_EQ(savings.size(), kMethods.size());
        EXPECT_EQ(m_round.cells.at(2).effects, "without object_motion,reprojection,light_buffers");
        for (const SavingRecord& saving : savings) {
            EXPECT_LE(saving.largest_difference, 1.0 / 255.0) << saving.cell;
            EXPECT_EQ(saving.n, kSavingRepeats);
            EXPECT_GT(saving.ratio, 0.0);
        }
    }
}

TEST_F(PlannedImages, StayWithinOneCodeWhereOnlyTheCameraMoves) {
    for (const SavingRecord& saving : measure("cathedral:detail=0.125", "20:28", kMethods)) {
        EXPECT_LE(saving.largest_difference, 1.0 / 255.0) << saving.cell;
    }
}

TEST_F(PlannedImages, LeaveNothingOfUseOutWhereObjectsMove) {
    const std::vector<SavingRecord> savings = measure("lifted_box", "56:64", {"tssao"});
    EXPECT_EQ(m_round.cells.at(2).effects, "without light_buffers");
    ASSERT_EQ(savings.size(), 1u);
    EXPECT_LE(savings[0].largest_difference, 1.0 / 255.0);
}

TEST_F(PlannedImages, AnEffectThatIsCalledForShows) {
    // What the tests above would say of a plan that is wrong.
    const Units units = get_units();
    Experiment experiment;
    experiment.scenes = {{"lifted_box", std::nullopt}};
    experiment.frames = {FrameChoice::Kind::ranges, {"56:64"}};
    experiment.sizes = {{96, 72}};
    experiment.methods = {parse_method_spec("tssao")};
    PlanRecord record = make_plan(experiment, units).record;
    record.rounds.at(0).cells.at(2).effects = "without object_motion,reprojection";
    std::vector<std::string> warnings;
    const std::unique_ptr<Scene> scene = open_scene(units.scenes, "lifted_box", warnings);
    const std::vector<SavingRecord> savings = measure_savings(
        context(), gl::TimerMode::fenced_wall, units, record, record.rounds.at(0), *scene);
    ASSERT_EQ(savings.size(), 1u);
    EXPECT_GT(savings[0].largest_difference, 5.0 / 255.0);
}

} // namespace
} // namespace alcove
