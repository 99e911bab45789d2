#include "harness/run/scene_source.hpp"

#include "harness/run/plan.hpp"
#include "scenes/registry.hpp"
#include "tests/harness/expect_error.hpp"

namespace alcove {
namespace {

std::unique_ptr<Scene> open_spec(const std::string& spec) {
    std::vector<std::string> warnings;
    return open_scene(scenes_registry(), spec, warnings);
}

TEST(SceneSource, ReadsANameAndItsParameters) {
    const SceneSpec bare = parse_scene_spec("cathedral");
    EXPECT_EQ(bare.name, "cathedral");
    EXPECT_TRUE(bare.overrides.empty());
    const SceneSpec spec = parse_scene_spec("lifted_box:motion=slide,speed=fast");
    EXPECT_EQ(spec.name, "lifted_box");
    ASSERT_EQ(spec.overrides.size(), 2u);
    EXPECT_EQ(spec.overrides[1].name, "speed");
    EXPECT_EQ(spec.overrides[1].value, "fast");
}

TEST(SceneSource, RefusesWhatIsNoSpecification) {
    expect_error([] { static_cast<void>(parse_scene_spec("lifted_box:")); }, 2, {"--scene"});
    expect_error([] { static_cast<void>(parse_scene_spec("lifted_box:fast")); }, 2,
                 {"--scene", "fast", "key=value"});
    expect_error([] { static_cast<void>(parse_scene_spec("lifted_box:speed=fast,speed=slow")); }, 2,
                 {"--scene", "speed", "twice"});
}

TEST(SceneSource, NamesTheNearestOfEachPart) {
    expect_error([] { static_cast<void>(open_spec("lifted_bx:speed=fast")); }, 2,
                 {"scenes", "nearest: lifted_box"});
    expect_error([] { static_cast<void>(open_spec("lifted_box:sped=fast")); }, 2,
                 {"lifted_box", "nearest: speed"});
    expect_error([] { static_cast<void>(open_spec("lifted_box:speed=fats")); }, 2,
                 {"lifted_box", "nearest: fast"});
    expect_error([] { static_cast<void>(open_spec("cathedral:detail=300")); }, 2,
                 {"cathedral", "detail", "300", "256"});
    expect_error([] { static_cast<void>(open_spec("template_scene:detail=1")); }, 2,
                 {"template_scene", "detail"});
}

TEST(SceneSource, EverySceneTakesLightBesideItsOwnParameters) {
    const auto scene = open_spec(
        "colour_blocks:walkthrough=turning,environment=two_colour,shadows=true,lamp=point");
    EXPECT_NE(scene->get_lights().environment, nullptr);
    EXPECT_TRUE(scene->get_lights().directional.at(0).casts_shadow);
    EXPECT_EQ(scene->get_lights().points.size(), 1u);
    expect_error([] { static_cast<void>(open_spec("colour_blocks:enviroment=sky")); }, 2,
                 {"colour_blocks", "nearest: environment"});
    expect_error([] { static_cast<void>(open_spec("colour_blocks:environment=skye")); }, 2,
                 {"environment", "nearest: sky"});
    expect_error([] { static_cast<void>(open_spec("colour_blocks:environment=a/sky")); }, 2,
                 {"a/sky", ".hdr or .exr"});
    expect_error([] { static_cast<void>(open_spec("colour_blocks:environment=no.hdr")); }, 2,
                 {"no.hdr"});
}

TEST(SceneSource, EveryPathOfASpecificationIsResolved) {
    const auto resolve = [](const std::string& path) { return "/base/" + path; };
    EXPECT_EQ(resolve_scene_paths("cathedral:detail=2,environment=a.hdr", resolve),
              "cathedral:detail=2,environment=/base/a.hdr");
    EXPECT_EQ(resolve_scene_paths("cathedral:environment=sky", resolve),
              "cathedral:environment=sky");
    EXPECT_EQ(resolve_scene_paths("m.glb:environment=a.exr,shadows=true", resolve),
              "/base/m.glb:environment=/base/a.exr,shadows=true");
}

TEST(SceneSource, ParametersReachTheScene) {
    EXPECT_LT(count_size(*open_spec("cathedral:detail=0.125")).vertices,
              count_size(*open_spec("cathedral:detail=0.25")).vertices);
}

TEST(SceneSource, TwoSpecificationsOfOneSceneAreTwoRoundsAndOneDescription) {
    Experiment experiment;
    experiment.scenes = {{"cathedral:detail=0.125", std::nullopt},
                         {"template_scene", std::nullopt},
                         {"cathedral:seed=2,detail=0.125", std::nullopt}};
    experiment.sizes = {{96, 72}};
    experiment.methods = {parse_method_spec("none")};
    const PlanRecord plan = make_plan(experiment, get_units()).record;
    ASSERT_EQ(plan.rounds.size(), 3u);
    EXPECT_EQ(plan.rounds[0].scene, "cathedral:detail=0.125");
    EXPECT_EQ(plan.rounds[2].scene, "cathedral:seed=2,detail=0.125");
    EXPECT_NE(plan.rounds[0].id, plan.rounds[2].id);
    for (const RoundRecord& round : plan.rounds) {
        EXPECT_EQ(round.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-"),
                  std::string::npos)
            << round.id;
    }
    ASSERT_EQ(plan.scenes.size(), 2u);
    EXPECT_EQ(plan.scenes[0].name, "cathedral");
    EXPECT_EQ(plan.scenes[1].name, "template_scene");
}

TEST(SceneSource, WrongParametersOfAMissingSceneAreStillRefused) {
    Experiment experiment;
    experiment.scenes = {{"bunny:trun=1", std::nullopt}};
    experiment.methods = {parse_method_spec("none")};
    expect_error([&] { static_cast<void>(make_plan(experiment, get_units())); }, 2,
                 {"bunny", "nearest: turn"});
}

} // namespace
} // namespace alcove
