#include "scenes/statue/statue.hpp"

#include "core/base/error.hpp"
#include "scenes/common/bunny_mesh.hpp"
#include "tests/scenes/deforming_check.hpp"
#include "tests/scenes/solid_check.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Scene> open(const std::string& motion = "turn", const std::string& piece = "knot",
                            const std::string& detail = "0.2") {
    const SceneUnit unit = statue_unit();
    const std::vector<ParameterOverride> overrides{
        {"motion", motion}, {"piece", piece}, {"detail", detail}};
    return unit.open(unit.parameters.resolve(overrides, {}));
}

constexpr std::size_t kPiece = 2; ///< object

TEST(Statue, IsMadeOfClosedSolidsWithOutwardNormals) {
    for (const char* detail : {"0.05", "1"}) {
        const std::unique_ptr<Scene> scene = open("turn", "knot", detail);
        for (const Mesh& mesh : scene->get_meshes()) {
            const SolidCheck check = check_solid(mesh);
            EXPECT_EQ(check.open_edges, 0u) << mesh.name;
            EXPECT_GT(check.volume, 0.01) << mesh.name;
            EXPECT_EQ(count_inverted_corners(mesh), 0u) << mesh.name;
        }
    }
}

TEST(Statue, GrowsWithDetail) {
    EXPECT_NEAR(static_cast<double>(count_size(*open("rest", "knot", "1")).vertices), 31'000.0,
                1'000.0);
    EXPECT_GT(count_size(*open("rest", "knot", "4")).vertices, 120'000u);
}

class StatueMotion : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, StatueMotion,
                         testing::Values("turn", "slide", "turn_and_slide", "rest"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(StatueMotion, IsOfConstantSpeedUnderAStillCamera) {
    const std::string motion = GetParam();
    const std::unique_ptr<Scene> scene = open(motion);
    EXPECT_EQ(scene->is_static(), motion == "rest");
    const bool turns = motion == "turn" || motion == "turn_and_slide";
    const bool slides = motion == "slide" || motion == "turn_and_slide";
    const Walkthrough& walkthrough = scene->get_walkthrough();
    ASSERT_GE(walkthrough.cameras.size(), 120u);
    const auto place = [&](int frame) {
        return scene->compute_pose(frame * walkthrough.step_s).object_to_world[kPiece];
    };
    for (int frame = 0; frame < 109; ++frame) {
        const glm::dmat4 now = place(frame);
        const glm::dmat4 next = place(frame + 1);
        const bool moves = frame >= 10 && frame < 100;
        const double cosine = now[0].x * next[0].x + now[0].z * next[0].z;
        EXPECT_NEAR(cosine, std::cos(turns && moves ? 2.0 * std::numbers::pi / 180.0 : 0.0), 1e-9);
        EXPECT_NEAR(next[3].x - now[3].x, slides && moves ? 0.008 : 0.0, 1e-9) << frame;
        EXPECT_NEAR(next[3].y, now[3].y, 1e-12);
        EXPECT_EQ(walkthrough.cameras[static_cast<std::size_t>(frame)].position,
                  walkthrough.cameras[109].position);
    }
    EXPECT_NE(walkthrough.cameras[110].position, walkthrough.cameras[179].position);
}

TEST_P(StatueMotion, KeepsThePieceOnThePlinthAndTheCameraClear) {
    const std::unique_ptr<Scene> scene = open(GetParam(), "knot", "0.05");
    for (const int frame : {0, 55, 120}) {
        const Mesh piece = pose_mesh(*scene, kPiece, frame / 30.0);
        for (const glm::vec3& position : piece.positions) {
            EXPECT_GT(position.y, 0.34f);
            EXPECT_LT(std::abs(position.x), 1.25f);
            EXPECT_LT(std::abs(position.z), 0.75f);
        }
    }
    EXPECT_GT(measure_camera_clearance(*scene, 10), 0.2);
}

TEST(Statue, TakesTheBunnyIfItIsThere) {
    if (find_bunny_obstacle()) {
        EXPECT_THROW(static_cast<void>(open("turn", "bunny")), InputError);
        GTEST_SKIP() << *find_bunny_obstacle();
    }
    const std::unique_ptr<Scene> scene = open("turn", "bunny");
    EXPECT_EQ(scene->get_meshes()[kPiece].positions.size(), 1839u);
    EXPECT_GT(measure_camera_clearance(*scene, 10), 0.2);
    EXPECT_FALSE(statue_unit().find_obstacle()); // the knot needs nothing
}

} // namespace
} // namespace alcove
