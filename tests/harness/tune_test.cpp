// Tuning where the answer is known: a method fitted to itself with other settings.
#include "harness/tune/tune_method.hpp"

#include "core/base/text.hpp"
#include "harness/run/environment.hpp"
#include "harness/tune/free_parameter.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/harness/expect_error.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

TEST(FreeParameter, ARadiusIsSearchedAroundTheTargets) {
    const Units units = get_units();
    const FreeParameter radius(units.methods.find("hemisphere_ssao").parameters.find("radius"));
    EXPECT_TRUE(radius.is_relative());
    EXPECT_EQ(radius.describe(0.0), "0.25 * scene_radius");
    EXPECT_EQ(radius.describe(0.5), "1 * scene_radius");
    EXPECT_EQ(radius.describe(1.0), "4 * scene_radius");
}

TEST(FreeParameter, OthersAreSearchedOnTheirOwnScaleAndRange) {
    const Units units = get_units();
    const ParameterTable& table = units.methods.find("hemisphere_ssao").parameters;
    const FreeParameter strength(table.find("strength"));
    EXPECT_EQ(strength.describe(0.5), "1"); // 0.1 .. 10, log
    const FreeParameter bias(table.find("bias"));
    EXPECT_EQ(bias.describe(0.25), "1"); // 0 .. 4, linear
    const FreeParameter samples(table.find("samples"));
    EXPECT_EQ(samples.describe(1.0), "512");
    EXPECT_EQ(samples.describe(0.5), "23"); // sqrt(512) = 22.6
    EXPECT_THROW(FreeParameter(table.find("directions")), InputError);
}

TEST(FreeParameter, DefaultsToRadiusAndStrength) {
    const Units units = get_units();
    const auto names = [](const std::vector<FreeParameter>& free) {
        std::vector<std::string> list;
        for (const FreeParameter& parameter : free) {
            list.push_back(parameter.name());
        }
        return list;
    };
    EXPECT_EQ(names(choose_free_parameters(units.methods.find("tssao"), {})),
              (std::vector<std::string>{"radius", "strength"}));
    EXPECT_EQ(names(choose_free_parameters(units.methods.find("tssao"), {"cut"})),
              (std::vector<std::string>{"cut"}));
    expect_error([&] { static_cast<void>(choose_free_parameters(units.methods.find("none"), {})); },
                 2, {"nothing to tune", "none"});
    expect_error(
        [&] {
            static_cast<void>(choose_free_parameters(units.methods.find("tssao"), {"cut", "cut"}));
        },
        2, {"twice"});
}

class TuneTest : public GlTest {
  protected:
    TuneTest() : m_cache("ALCOVE_CACHE", (m_folder.path() / "cache").string()) {
        m_plan.methods = {parse_method_spec("hemisphere_ssao")};
        m_plan.scenes = {"template_scene"};
        m_plan.size = {64, 48};
        m_plan.judge = "ssim";
        m_plan.evaluations_per_parameter = 16;
    }
    TuneRecord tune(const TuneEvents& events = {}) {
        return run_tune(m_plan, context(), describe_environment(context(), {}), m_units, events);
    }
    static double read_multiple(const std::string& text) {
        return parse_number(text.substr(0, text.find(' ')), "tuned");
    }
    static const TuneJudgementRecord& find(const TunedMethodRecord& method, std::string_view set,
                                           bool is_objective) {
        return *std::find_if(method.judgements.begin(), method.judgements.end(),
                             [&](const TuneJudgementRecord& j) {
                                 return j.set == set && j.is_objective == is_objective;
                             });
    }

    TemporaryFolder m_folder;
    ScopedVariable m_cache;
    const Units m_units = get_units();
    TunePlan m_plan;
};

TEST_F(TuneTest, RecoversTheSettingsOfAMethodFittedToItself) {
    m_plan.reference = parse_method_spec("hemisphere_ssao:radius=0.8,strength=0.7", "--reference");
    const TuneRecord record = tune();
    const TunedMethodRecord& method = record.methods.at(0);
    ASSERT_EQ(method.parameters.size(), 2u);
    // The scene's radius is 0.5 m.
    EXPECT_NEAR(read_multiple(method.parameters[0].tuned), 1.6, 0.1);
    EXPECT_NEAR(read_multiple(method.parameters[1].tuned), 0.7, 0.05);
    // Away from the answer it costs more, either way.
    EXPECT_GT(method.parameters[0].lower_ratio, 1.5);
    EXPECT_GT(method.parameters[1].upper_ratio, 1.5);
    const TuneJudgementRecord& held_out = find(method, "held-out frames", true);
    EXPECT_LT(held_out.after, 0.2 * held_out.before);
    const TuneJudgementRecord& judged = find(method, "held-out frames", false);
    EXPECT_EQ(judged.metric, "ssim");
    EXPECT_GT(judged.after, judged.before);
    EXPECT_LT(std::abs(find_generalisation_gap(method, held_out).value()), 0.2);
}

TEST_F(TuneTest, EffortIsInProportionToTheFreeParameters) {
    m_plan.evaluations_per_parameter = 4;
    m_plan.free = {"strength"};
    EXPECT_EQ(tune().methods.at(0).evaluations, 4);
    m_plan.free = {"strength", "radius", "cut"};
    const TuneRecord record = tune();
    const TunedMethodRecord& method = record.methods.at(0);
    EXPECT_EQ(method.evaluations, 12);
    ASSERT_EQ(method.least_costs.size(), 2u);
    for (const int attempt : {0, 1}) {
        const auto count = std::count_if(
            method.history.begin(), method.history.end(),
            [&](const TuneEvaluationRecord& evaluation) { return evaluation.attempt == attempt; });
        EXPECT_LE(count, 12);
        EXPECT_GE(count, 8);
    }
}

TEST_F(TuneTest, FramesThatTrainDoNotJudge) {
    m_plan.evaluations_per_parameter = 4;
    m_plan.free = {"strength"};
    m_plan.held_out_scenes = {"lifted_box"};
    std::string calibration;
    TuneEvents events;
    events.method_done = [&](const TuneRecord&, const TunedMethodRecord& method,
                             const std::string& text) {
        calibration = text;
        EXPECT_EQ(method.calibration, "hemisphere_ssao/preset.toml");
    };
    const TuneRecord record = tune(events);
    ASSERT_EQ(record.scenes.size(), 2u);
    EXPECT_EQ(record.scenes[0].training.size(), 4u);
    EXPECT_EQ(record.scenes[0].held_out.size(), 4u);
    for (const int frame : record.scenes[0].training) {
        EXPECT_EQ(
            std::count(record.scenes[0].held_out.begin(), record.scenes[0].held_out.end(), frame),
            0);
    }
    EXPECT_TRUE(record.scenes[1].training.empty());
    EXPECT_EQ(record.scenes[1].held_out.size(), 8u);
    EXPECT_EQ(find(record.methods[0], "held-out scenes", true).frames, 8);
    EXPECT_NE(calibration.find("strength = \""), std::string::npos);
}

TEST_F(TuneTest, WhatIsWrittenIsRead) {
    m_plan.evaluations_per_parameter = 4;
    m_plan.free = {"strength"};
    const TuneRecord record = tune();
    write_tune(m_folder.path(), record);
    const TuneRecord read = read_tune(m_folder.path());
    ASSERT_EQ(read.methods.size(), 1u);
    EXPECT_EQ(read.methods[0].parameters[0].tuned, record.methods[0].parameters[0].tuned);
    EXPECT_EQ(read.methods[0].history.size(), record.methods[0].history.size());
    EXPECT_EQ(read.methods[0].judgements[0].lower, record.methods[0].judgements[0].lower);
    m_folder.write("tune.json", "{}");
    EXPECT_THROW(static_cast<void>(read_tune(m_folder.path())), InputError);
}

TEST_F(TuneTest, RefusesWhatCannotBeTuned) {
    const auto expect = [&](std::initializer_list<const char*> parts) {
        expect_error([&] { static_cast<void>(tune()); }, 2, parts);
    };
    m_plan.judge = "rmse";
    expect({"--judge", "is the objective itself"});
    m_plan.judge = "temporal_flicker";
    expect({"--judge", "is over time"});
    m_plan.judge = "ssim";
    m_plan.evaluations_per_parameter = 3;
    expect({"--evaluations", "4 to 1000"});
    m_plan.evaluations_per_parameter = 4;
    m_plan.methods = {parse_method_spec("hemisphere_ssao:radius=2")};
    expect({"cannot be set as well", "radius"});
    m_plan.methods = {parse_method_spec("none")};
    expect({"nothing to tune"});
}

} // namespace
} // namespace alcove
