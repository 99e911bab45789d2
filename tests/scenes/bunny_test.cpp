#include "scenes/bunny/bunny.hpp"

#include "core/base/error.hpp"
#include "scenes/common/bunny_package.hpp"
#include "tests/scenes/solid_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Scene> open_default() {
    const SceneUnit unit = bunny_unit();
    return unit.open(unit.parameters.resolve({}, {}));
}

class BunnyScene : public testing::Test {
  protected:
    void SetUp() override {
        if (const auto obstacle = bunny_unit().find_obstacle()) {
            GTEST_SKIP() << *obstacle;
        }
        m_scene = open_default();
        m_bunny = &m_scene->get_meshes()[0];
    }
    std::unique_ptr<Scene> m_scene;
    const Mesh* m_bunny = nullptr;
};

TEST_F(BunnyScene, IsTheWholeScan) {
    EXPECT_EQ(m_bunny->positions.size(), 1839u);
    EXPECT_EQ(m_bunny->indices.size(), 3u * 3674u);
}

TEST_F(BunnyScene, IsClosedAndTurnedOutward) {
    const SolidCheck check = check_solid(*m_bunny);
    EXPECT_EQ(check.open_edges, 0u);
    EXPECT_NEAR(check.volume, 0.194, 0.002); // 194.3 cubic units of 0.1 m
}

TEST_F(BunnyScene, RestsUnlessItIsToldToTurn) {
    EXPECT_TRUE(m_scene->is_static());
    EXPECT_EQ(m_scene->get_walkthrough().name, "default");
    EXPECT_TRUE(m_scene->get_walkthrough().tracks.empty());
}

TEST_F(BunnyScene, TurnsByItsParameterFromFrame10ToFrame90) {
    const SceneUnit unit = bunny_unit();
    const std::vector<ParameterOverride> overrides{{"turn", "4.5"}};
    const std::unique_ptr<Scene> scene = unit.open(unit.parameters.resolve(overrides, {}));
    EXPECT_NO_THROW(check_scene(*scene, "bunny"));
    EXPECT_FALSE(scene->is_static());
    const Walkthrough& walkthrough = scene->get_walkthrough();
    ASSERT_EQ(walkthrough.cameras.size(), 120u);
    for (int frame = 0; frame < 120; ++frame) {
        const Pose pose = scene->compute_pose(frame * walkthrough.step_s);
        const double angle = std::clamp(frame - 10, 0, 80) * 4.5 * std::numbers::pi / 180.0;
        // Turned about +y: the object's x axis goes towards -z.
        const glm::dmat4& bunny = pose.object_to_world[0];
        EXPECT_NEAR(bunny[0].x, std::cos(angle), 1e-12) << frame;
        EXPECT_NEAR(bunny[0].z, -std::sin(angle), 1e-12) << frame;
        EXPECT_EQ(bunny[3], glm::dvec4(0.0, 0.0, 0.0, 1.0)) << frame;
        EXPECT_EQ(pose.object_to_world[1], glm::dmat4(1.0)) << frame;
        EXPECT_EQ(walkthrough.cameras[static_cast<std::size_t>(frame)].position,
                  walkthrough.cameras[0].position);
    }
    ASSERT_EQ(walkthrough.events.size(), 2u);
    EXPECT_EQ(walkthrough.events[0].frame, 10);
    EXPECT_EQ(walkthrough.events[1].frame, 90);
}

TEST_F(BunnyScene, StandsOnTheFloorAndIsAboutAMetreHigh) {
    float low = 1e9f;
    float high = -1e9f;
    for (const glm::vec3& position : m_bunny->positions) {
        low = std::min(low, position.y);
        high = std::max(high, position.y);
    }
    EXPECT_EQ(low, 0.0f);
    EXPECT_NEAR(high, 0.9658, 0.0005);
    const Mesh& floor = m_scene->get_meshes()[1];
    float top = -1e9f;
    for (const glm::vec3& position : floor.positions) {
        top = std::max(top, position.y);
    }
    EXPECT_EQ(top, 0.0f);
}

TEST_F(BunnyScene, HasNoFaceInThePlaneOfTheFloor) {
    for (std::size_t i = 0; i < m_bunny->indices.size(); i += 3) {
        float highest = 0.0f;
        for (std::size_t k = 0; k < 3; ++k) {
            highest = std::max(highest, m_bunny->positions[m_bunny->indices[i + k]].y);
        }
        EXPECT_GT(highest, 1e-4f);
    }
}

TEST_F(BunnyScene, IsTheSameTwice) {
    EXPECT_EQ(hash_geometry(*m_scene, 0.0), hash_geometry(*open_default(), 7.0));
    EXPECT_NO_THROW(check_scene(*m_scene, "bunny"));
    EXPECT_EQ(m_scene->get_walkthrough().cameras.size(), 120u);
}

TEST(BunnyPackage, TellsTheCommandWhenItIsMissing) {
    const char* before = std::getenv("ALCOVE_NODE_MODULES");
    const std::string kept = before == nullptr ? "" : before;
    ::setenv("ALCOVE_NODE_MODULES", "/nonexistent", 1);
    const auto obstacle = bunny_unit().find_obstacle();
    ASSERT_TRUE(obstacle.has_value());
    EXPECT_NE(obstacle->find("npm ci"), std::string::npos);
    EXPECT_THROW(static_cast<void>(open_default()), InputError);
    if (before == nullptr) {
        ::unsetenv("ALCOVE_NODE_MODULES");
    } else {
        ::setenv("ALCOVE_NODE_MODULES", kept.c_str(), 1);
    }
}

TEST(BunnyPackage, ReadsArraysWithoutExecuting) {
    const BunnyData data = parse_bunny_package(
        "exports.positions = [[0,0,0],[1,0,0],[0,1.5,-2e-1]]\nexports.cells=[[0,1,2]]\n", "x.js");
    ASSERT_EQ(data.positions.size(), 3u);
    EXPECT_EQ(data.positions[2], glm::dvec3(0.0, 1.5, -0.2));
    ASSERT_EQ(data.cells.size(), 1u);
    EXPECT_EQ(data.cells[0][2], 2u);
}

TEST(BunnyPackage, RejectsWhatIsNotTwoArrays) {
    const std::string positions = "exports.positions=[[0,0,0],[1,0,0],[0,1,0]]\n";
    const auto parse = [](const std::string& text) {
        static_cast<void>(parse_bunny_package(text, "x.js"));
    };
    EXPECT_THROW(parse(""), InputError);
    EXPECT_THROW(parse(positions), InputError);
    EXPECT_THROW(parse(positions + "exports.cells=[[0,1,2]"), InputError);
    EXPECT_THROW(parse(positions + "exports.cells=[]"), InputError);
    EXPECT_THROW(parse(positions + "exports.cells=[[0,1]]"), InputError);
    EXPECT_THROW(parse(positions + "exports.cells=[[0,1,3]]"), InputError);
    EXPECT_THROW(parse(positions + "exports.cells=[[0,1,-1]]"), InputError);
    EXPECT_THROW(parse(positions + "exports.cells=[[0,1,f()]]"), InputError);
    EXPECT_THROW(parse("exports.positions=[[0,0]]\nexports.cells=[[0,0,0]]"), InputError);
    EXPECT_THROW(parse("exports.positions=[[1e999,0,0]]\nexports.cells=[[0,0,0]]"), InputError);
}

} // namespace
} // namespace alcove
