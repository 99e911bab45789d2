#include "scenes/skeleton/skeleton.hpp"

#include "scenes/common/skeleton_figure.hpp"
#include "tests/scenes/deforming_check.hpp"
#include "tests/scenes/solid_check.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Scene> open(const std::string& thickness = "0.025",
                            const std::string& speed = "1.2", const std::string& detail = "0.3") {
    const SceneUnit unit = skeleton_unit();
    const std::vector<ParameterOverride> overrides{
        {"thickness", thickness}, {"speed", speed}, {"detail", detail}};
    return unit.open(unit.parameters.resolve(overrides, {}));
}

class SkeletonThickness : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Range, SkeletonThickness, testing::Values("0.005", "0.025", "0.08"),
                         [](const auto& tested) { return "Mm" + std::string(tested.param + 2); });

TEST_P(SkeletonThickness, EveryBoneIsClosedAndTurnedOutward) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    for (const Mesh& mesh : scene->get_meshes()) {
        const SolidCheck check = check_solid(mesh);
        EXPECT_EQ(check.open_edges, 0u) << mesh.name;
        EXPECT_GT(check.volume, 1e-7) << mesh.name;
        EXPECT_LE(count_inverted_corners(mesh), mesh.indices.size() / 500) << mesh.name;
        EXPECT_TRUE(mesh.closed) << mesh.name;
    }
}

TEST_P(SkeletonThickness, IsTheDiameterOfTheShafts) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    const Mesh& thigh =
        scene->get_meshes()[scene->get_objects()[find_objects(*scene, "thigh")[0]].mesh];
    const double middle = -0.5 * get_skeleton_body().thigh_length;
    double radius = 1e30;
    for (const glm::vec3& p : thigh.positions) {
        if (std::abs(p.y - middle) < 0.06) {
            radius = std::min(radius, std::hypot(double(p.x), double(p.z)));
        }
    }
    const double thickness = std::stod(GetParam());
    EXPECT_NEAR(2.0 * radius, thickness, 0.12 * thickness);
}

TEST(Skeleton, FeetStandWithoutSlidingAtEverySpeed) {
    for (const char* speed : {"0.2", "1.2", "3"}) {
        const std::unique_ptr<Scene> scene = open("0.025", speed, "0.1");
        const std::vector<std::size_t> feet = find_objects(*scene, "foot#");
        ASSERT_EQ(feet.size(), 2u);
        // At 3 m/s a stance lasts six frames.
        const FootCheck check = check_feet(*scene, feet[0], feet[1], 0, 129);
        EXPECT_LT(check.slide_m, 0.01) << speed;
        EXPECT_NEAR(check.highest_m, 0.0, 0.02) << speed;
        EXPECT_GT(check.lowest_m, -0.05) << speed;
    }
}

TEST(Skeleton, LimbsHangTogether) {
    const std::unique_ptr<Scene> scene = open();
    const WalkerBody& body = get_skeleton_body();
    const std::size_t thigh = find_objects(*scene, "thigh#")[0];
    const std::size_t shin = find_objects(*scene, "shin#")[0];
    const std::size_t foot = find_objects(*scene, "foot#")[0];
    for (int frame = 0; frame < 60; ++frame) {
        const Pose pose = scene->compute_pose(frame / 30.0);
        const auto end = [&](std::size_t object, double length) {
            return glm::dvec3(pose.object_to_world[object] * glm::dvec4(0.0, -length, 0.0, 1.0));
        };
        EXPECT_LT(glm::distance(end(thigh, body.thigh_length), end(shin, 0.0)), 1e-9);
        EXPECT_LT(glm::distance(end(shin, body.shin_length), end(foot, 0.0)), 0.01);
    }
}

TEST(Skeleton, WalksAtItsSpeedAndTheCloseUpGoesAlong) {
    const std::unique_ptr<Scene> scene = open("0.025", "2");
    const std::size_t trunk = find_objects(*scene, "trunk")[0];
    const auto place = [&](int frame) {
        return scene->compute_pose(frame / 30.0).object_to_world[trunk][3].x;
    };
    EXPECT_NEAR(place(90) - place(30), 4.0, 0.01);
    EXPECT_NEAR(place(60), 0.0, 0.05);
    const Walkthrough& walkthrough = scene->get_walkthrough();
    ASSERT_GE(walkthrough.cameras.size(), 120u);
    EXPECT_EQ(walkthrough.cuts, (std::vector<int>{0, 65}));
    EXPECT_EQ(walkthrough.cameras[0].position, walkthrough.cameras[64].position);
    for (const int frame : {70, 100, 129}) {
        const Camera& camera = walkthrough.cameras[static_cast<std::size_t>(frame)];
        EXPECT_LT(std::abs(camera.position.x - place(frame)), 1.0) << frame;
    }
}

TEST(Skeleton, TheCameraStaysClearOfAllSolids) {
    for (const char* speed : {"0.2", "3"}) {
        EXPECT_GT(measure_camera_clearance(*open("0.08", speed, "0.1"), 13), 0.3) << speed;
    }
}

TEST(Skeleton, IsDecidedByItsParametersAndTheTime) {
    const std::string hash = hash_geometry(*open(), 0.5);
    EXPECT_EQ(hash, hash_geometry(*open(), 0.5));
    EXPECT_NE(hash, hash_geometry(*open(), 0.6));
    EXPECT_NE(hash, hash_geometry(*open("0.03"), 0.5));
    EXPECT_NE(hash, hash_geometry(*open("0.025", "1.3"), 0.5));
}

} // namespace
} // namespace alcove
