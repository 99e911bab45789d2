#include "scenes/crowd/crowd.hpp"

#include "tests/scenes/deforming_check.hpp"
#include "tests/scenes/solid_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Scene> open(const std::string& detail = "1", const std::string& seed = "1") {
    const SceneUnit unit = crowd_unit();
    const std::vector<ParameterOverride> overrides{{"detail", detail}, {"seed", seed}};
    return unit.open(unit.parameters.resolve(overrides, {}));
}

TEST(Crowd, HasTwelveDeformingKnightsAndGrowsToHalfAMillionTriangles) {
    const std::unique_ptr<Scene> scene = open();
    EXPECT_EQ(find_objects(*scene, " body").size(), 12u);
    EXPECT_EQ(find_objects(*scene, " cloak").size(), 12u);
    EXPECT_NEAR(static_cast<double>(count_size(*scene).triangles), 65'000.0, 10'000.0);
    EXPECT_NEAR(static_cast<double>(count_size(*open("10.2")).triangles), 500'000.0, 15'000.0);
}

TEST(Crowd, BodiesAndCloaksStayClosed) {
    const std::unique_ptr<Scene> scene = open();
    for (const double time_s : {0.0, 2.4}) {
        for (std::size_t i = 0; i < scene->get_objects().size(); ++i) {
            const Mesh mesh = pose_mesh(*scene, i, time_s);
            const SolidCheck check = check_solid(mesh);
            EXPECT_EQ(check.open_edges, 0u) << scene->get_objects()[i].name;
            EXPECT_GT(check.volume, 0.0) << scene->get_objects()[i].name;
            EXPECT_LE(count_inverted_corners(mesh), mesh.indices.size() / 200)
                << scene->get_objects()[i].name;
        }
    }
}

TEST(Crowd, KnightsKeepTheirDistance) {
    for (const char* seed : {"1", "2"}) {
        const std::unique_ptr<Scene> scene = open("1", seed);
        const std::vector<std::size_t> helmets = find_objects(*scene, "helmet");
        ASSERT_EQ(helmets.size(), 12u);
        const Walkthrough& walkthrough = scene->get_walkthrough();
        for (std::size_t frame = 0; frame < walkthrough.cameras.size(); frame += 3) {
            const Pose pose = scene->compute_pose(static_cast<double>(frame) * walkthrough.step_s);
            for (std::size_t a = 0; a < helmets.size(); ++a) {
                for (std::size_t b = a + 1; b < helmets.size(); ++b) {
                    EXPECT_GT(glm::distance(pose.object_to_world[helmets[a]][3],
                                            pose.object_to_world[helmets[b]][3]),
                              1.2)
                        << frame;
                }
            }
        }
    }
}

TEST(Crowd, NoTwoWalkInStep) {
    const std::unique_ptr<Scene> scene = open();
    std::set<long> sways;
    for (const std::size_t cloak : find_objects(*scene, " cloak")) {
        double sideways = 0.0;
        for (const glm::vec3& position : scene->deform(cloak, 1.0).positions) {
            sideways += static_cast<double>(position.z);
        }
        sways.insert(std::lround(1e4 * sideways));
    }
    EXPECT_EQ(sways.size(), 12u);
}

TEST(Crowd, FeetStandWithoutSlidingOnBothSenses) {
    const std::unique_ptr<Scene> scene = open();
    const std::vector<std::size_t> boots = find_objects(*scene, "boot");
    ASSERT_EQ(boots.size(), 24u);
    for (const std::size_t knight : {std::size_t{0}, std::size_t{11}}) {
        const FootCheck check = check_feet(*scene, boots[2 * knight], boots[2 * knight + 1], 0, 60);
        EXPECT_LT(check.slide_m, 1e-4);
        EXPECT_NEAR(check.highest_m, 0.0, 0.002);
    }
}

TEST(Crowd, TheCameraStaysClear) {
    EXPECT_GT(measure_camera_clearance(*open(), 15), 0.4);
}

TEST(Crowd, IsDecidedByItsParametersAndTheTime) {
    const std::string hash = hash_geometry(*open(), 0.5);
    EXPECT_EQ(hash, hash_geometry(*open(), 0.5));
    EXPECT_NE(hash, hash_geometry(*open("1", "2"), 0.5));
}

} // namespace
} // namespace alcove
