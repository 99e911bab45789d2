#include "harness/run/scene_file.hpp"

#include "harness/run/plan.hpp"
#include "harness/run/scene_source.hpp"
#include "scenes/common/gltf_export.hpp"
#include "scenes/registry.hpp"
#include "tests/harness/expect_error.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTwoFrames =
    R"({"version":2,"name":"mine","step_seconds":0.5,"frames":2,"near":0.1,"far":50,"cuts":[],)"
    R"("poses":[{"position":[0,1,4],"target":[0,1,0],"up":[0,1,0],"fov_y_degrees":50},)"
    R"({"position":[X,1,4],"target":[0,1,0],"up":[0,1,0],"fov_y_degrees":50}],)"
    R"("tracks":[{"object":"NAME.0","pivot":[0,0,0],"axis":[0,1,0],"keys":)"
    R"([{"frame":0,"translation":[0,0,0],"degrees":0},)"
    R"({"frame":1,"translation":[0,3,0],"degrees":0}]}]})";

class SceneFile : public testing::Test {
  protected:
    void SetUp() override {
        m_folder = fs::temp_directory_path() / ("alcove-scene-file-" + std::to_string(::getpid()));
        fs::create_directories(m_folder);
        const Registry<SceneUnit> scenes = scenes_registry();
        const SceneUnit& unit = scenes.find("template_scene");
        const auto scene = unit.open(unit.parameters.resolve({}, {}));
        static_cast<void>(export_gltf(*scene, m_folder / "a.glb"));
        m_object = scene->get_objects()[0].name;
        write_walkthrough("1");
    }
    void TearDown() override { fs::remove_all(m_folder); }

    void write_walkthrough(const std::string& x) const {
        std::string text = kTwoFrames;
        text.replace(text.find('X'), 1, x);
        text.replace(text.find("NAME"), 4, m_object);
        std::ofstream(m_folder / "w.json") << text;
    }

    [[nodiscard]] std::string file() const { return (m_folder / "a.glb").string(); }
    [[nodiscard]] std::string walkthrough() const { return (m_folder / "w.json").string(); }

    fs::path m_folder;
    std::string m_object;
};

TEST_F(SceneFile, TellsFilesFromNames) {
    EXPECT_TRUE(is_scene_file("a.glb"));
    EXPECT_TRUE(is_scene_file("a.gltf:animation=1"));
    EXPECT_TRUE(is_scene_file("folder/a"));
    EXPECT_FALSE(is_scene_file("bunny"));
    EXPECT_FALSE(is_scene_file("bunny:walkthrough=a/b"));
    EXPECT_EQ(get_scene_file("a:b.glb:animation=1"), "a:b.glb");
}

TEST_F(SceneFile, ReplaysTheUsersOwnWalkthrough) {
    std::vector<std::string> warnings;
    const auto scene = open_scene(
        scenes_registry(), file() + ":walkthrough=" + walkthrough() + ",ao_radius=0.25", warnings);
    EXPECT_EQ(scene->get_ao_radius_m(), 0.25);
    EXPECT_EQ(scene->get_walkthrough().name, "mine");
    ASSERT_EQ(scene->get_walkthrough().cameras.size(), 2u);
    EXPECT_EQ(scene->get_walkthrough().cameras[1].position, glm::dvec3(1.0, 1.0, 4.0));
    EXPECT_FALSE(scene->is_static());
    const glm::dvec3 moved(scene->compute_pose(0.5).object_to_world[0][3] -
                           scene->compute_pose(0.0).object_to_world[0][3]);
    EXPECT_EQ(moved, glm::dvec3(0.0, 3.0, 0.0));
}

TEST_F(SceneFile, NamesFileAndKey) {
    const auto open = [this](const std::string& options) {
        std::vector<std::string> warnings;
        static_cast<void>(open_scene_file(file() + ":" + options, warnings));
    };
    expect_error([&] { open("walkthrogh=x.json"); }, 2, {"a.glb", "nearest: walkthrough"});
    expect_error([&] { open("animation=one"); }, 2, {"a.glb: animation", "one"});
    expect_error([&] { open("animation=-1"); }, 2, {"a.glb: animation", "-1"});
    expect_error([&] { open("animation=7"); }, 2, {"a.glb", "animations[7]"});
    expect_error([&] { open("ao_radius=0"); }, 2, {"a.glb: ao_radius"});
    expect_error([&] { open("ao_radius=1,ao_radius=2"); }, 2, {"a.glb", "twice"});
    expect_error([&] { open("walkthrough=/nowhere.json"); }, 2, {"nowhere.json"});
    std::ofstream(m_folder / "w.json") << R"({"version":9})";
    expect_error([&] { open("walkthrough=" + walkthrough()); }, 2, {"w.json", "version"});
}

TEST_F(SceneFile, ItsContentIsTheFileAndTheWalkthrough) {
    const std::string spec = file() + ":walkthrough=" + walkthrough();
    const std::string before = hash_scene_file(spec);
    EXPECT_NE(before, hash_scene_file(file()));
    write_walkthrough("2");
    EXPECT_NE(before, hash_scene_file(spec));
}

TEST_F(SceneFile, APlanKnowsWhereTheFilesAre) {
    Experiment experiment;
    experiment.scenes = {
        {fs::relative(file()).string() + ":walkthrough=" + fs::relative(walkthrough()).string(),
         std::nullopt}};
    experiment.sizes = {{96, 72}};
    experiment.methods = {parse_method_spec("none")};
    const PlanRecord plan = make_plan(experiment, get_units()).record;
    ASSERT_EQ(plan.rounds.size(), 1u);
    EXPECT_EQ(plan.rounds[0].scene, file() + ":walkthrough=" + walkthrough());
    EXPECT_EQ(plan.rounds[0].id, "r001-a");
    ASSERT_EQ(plan.scenes.size(), 1u);
    EXPECT_EQ(plan.scenes[0].name, file());
    EXPECT_EQ(plan.scenes[0].content_hash, hash_scene_file(plan.rounds[0].scene));
}

} // namespace
} // namespace alcove
