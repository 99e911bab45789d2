#include "scenes/cathedral/cathedral.hpp"

#include "core/base/error.hpp"
#include "scenes/common/bunny_mesh.hpp"
#include "tests/scenes/deforming_check.hpp"
#include "tests/scenes/solid_check.hpp"
#include "tests/scenes/space_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Scene> open(const std::string& detail, const std::string& seed = "1",
                            const std::string& walkthrough = "default") {
    const SceneUnit unit = cathedral_unit();
    const std::vector<ParameterOverride> overrides{
        {"detail", detail}, {"seed", seed}, {"walkthrough", walkthrough}};
    return unit.open(unit.parameters.resolve(overrides, {}));
}

class CathedralDetail : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Range, CathedralDetail,
                         testing::Values("0.125", "0.5", "1", "2.7", "8", "9"),
                         [](const auto& tested) {
                             std::string name = tested.param;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

TEST(Cathedral, CoversTwentyToTwoHundredThousandVertices) {
    EXPECT_LE(count_size(*open("0.125")).vertices, 20'000u);
    EXPECT_NEAR(static_cast<double>(count_size(*open("1")).vertices), 60'000.0, 6'000.0);
    EXPECT_GE(count_size(*open("8")).vertices, 200'000u);
    std::size_t before = 0;
    for (const char* detail : {"0.125", "0.25", "0.5", "1", "2", "4", "8"}) {
        const std::size_t vertices = count_size(*open(detail)).vertices;
        EXPECT_GT(vertices, before) << detail;
        before = vertices;
    }
}

TEST(Cathedral, ReachesTheSizeOfThePublishedWalkthrough) {
    constexpr double kSibenik = 7'013'932.0; // TSSAO, table 2
    EXPECT_NEAR(static_cast<double>(count_size(*open("256")).vertices), kSibenik, 0.03 * kSibenik);
}

TEST(Cathedral, KeepsItsGeometryUpToDetailEight) {
    // Above, things are only added.
    const std::unique_ptr<Scene> below = open("8");
    const std::unique_ptr<Scene> above = open("8.0001");
    ASSERT_GT(above->get_objects().size(), below->get_objects().size());
    EXPECT_TRUE(std::equal(below->get_meshes().begin(), below->get_meshes().end(),
                           above->get_meshes().begin(), [](const Mesh& a, const Mesh& b) {
                               return a.name == b.name && a.positions.size() == b.positions.size();
                           }));
}

TEST(Cathedral, TheCameraOfTheLongWalkthroughStaysClear) {
    const std::unique_ptr<Scene> scene = open("9", "1", "full");
    const std::vector<Camera>& cameras = scene->get_walkthrough().cameras;
    ASSERT_EQ(cameras.size(), 3500u);
    for (std::size_t frame = 0; frame < cameras.size(); frame += 25) {
        const Pose pose =
            scene->compute_pose(static_cast<double>(frame) * scene->get_walkthrough().step_s);
        const glm::dvec3& eye = cameras[frame].position;
        const Clearance clearance =
            measure_clearance(collect_triangles_near(*scene, pose, eye, 0.5), eye);
        EXPECT_GT(clearance.distance_m, 0.2) << "frame " << frame;
        EXPECT_FALSE(clearance.inside) << "frame " << frame << " inside "
                                       << scene->get_objects()[clearance.inside.value_or(0)].name;
    }
}

TEST(Cathedral, TheSkeletonWalksTheAisleAndJumpsOnlyAtCuts) {
    const std::unique_ptr<Scene> scene = open("0.125", "1", "full");
    const Walkthrough& walkthrough = scene->get_walkthrough();
    const std::vector<std::size_t> feet = find_objects(*scene, "skeleton foot");
    const std::vector<std::size_t> trunks = find_objects(*scene, "skeleton trunk");
    ASSERT_EQ(feet.size(), 2u);
    ASSERT_EQ(trunks.size(), 1u);
    std::set<int> jumps;
    for (int frame = 0; frame + 1 < 3500; ++frame) {
        const Pose now = scene->compute_pose(frame * walkthrough.step_s);
        const Pose next = scene->compute_pose((frame + 1) * walkthrough.step_s);
        const glm::dvec3 trunk(now.object_to_world[trunks[0]][3]);
        if (glm::distance(trunk, glm::dvec3(next.object_to_world[trunks[0]][3])) > 0.1) {
            jumps.insert(frame + 1);
        }
        EXPECT_LT(std::abs(trunk.z), 0.01);
        EXPECT_GT(trunk.x, -13.0);
        EXPECT_LT(trunk.x, 8.0);
        EXPECT_GT(
            glm::distance(trunk, walkthrough.cameras[static_cast<std::size_t>(frame)].position),
            1.2)
            << frame;
    }
    EXPECT_EQ(jumps, (std::set<int>{700}));
    for (const int first : {0, 2550}) {
        const FootCheck check = check_feet(*scene, feet[0], feet[1], first, first + 120);
        EXPECT_LT(check.slide_m, 1e-4);
        EXPECT_NEAR(check.highest_m, 0.0, 0.01);
    }
}

TEST(Cathedral, GuestsComeToTheLongWalkthroughOnly) {
    const std::unique_ptr<Scene> building = open("0.125");
    const std::unique_ptr<Scene> visited = open("0.125", "1", "full");
    EXPECT_TRUE(building->is_static());
    EXPECT_FALSE(visited->is_static());
    EXPECT_TRUE(find_objects(*building, "skeleton").empty());
    EXPECT_EQ(find_objects(*visited, "skeleton").size(), 12u);
    EXPECT_EQ(find_objects(*visited, "bunny").size(), find_bunny_obstacle() ? 0u : 1u);
}

TEST(Cathedral, IsDecidedByItsParametersAlone) {
    const std::string hash = hash_geometry(*open("1", "1"), 0.0);
    EXPECT_EQ(hash, hash_geometry(*open("1", "1"), 3.0));
    EXPECT_NE(hash, hash_geometry(*open("1", "2"), 0.0));
    EXPECT_NE(hash, hash_geometry(*open("1", "0"), 0.0));
    EXPECT_NE(hash, hash_geometry(*open("1.5", "1"), 0.0));
}

TEST(Cathedral, RejectsParametersOutOfRange) {
    EXPECT_THROW(static_cast<void>(open("257")), InputError);
    EXPECT_THROW(static_cast<void>(open("0.1")), InputError);
    EXPECT_THROW(static_cast<void>(open("1", "-1")), InputError);
}

TEST_P(CathedralDetail, EveryMeshIsOneWatertightSolidTurnedOutward) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    check_scene(*scene, "cathedral");
    for (const Mesh& mesh : scene->get_meshes()) {
        const SolidCheck check = check_solid(mesh);
        EXPECT_EQ(check.open_edges, 0u) << mesh.name;
        EXPECT_GT(check.volume, 1e-6) << mesh.name;
    }
}

TEST_P(CathedralDetail, ShadingNormalsLookOutward) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    for (const Mesh& mesh : scene->get_meshes()) {
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
            const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
            const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
            const glm::dvec3 cross = glm::cross(b - a, c - a);
            if (glm::length(cross) < 1e-7) {
                continue; // a sliver's own direction is rounding
            }
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_GT(
                    glm::dot(glm::normalize(cross), glm::dvec3(mesh.normals[mesh.indices[i + k]])),
                    0.2)
                    << mesh.name << ", triangle " << i / 3;
            }
        }
    }
}

TEST_P(CathedralDetail, NoTwoSolidsShareAFace) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    EXPECT_EQ(list_shared_faces(*scene, collect_triangles(*scene, scene->compute_pose(0.0))), "");
}

TEST_P(CathedralDetail, TheCameraStaysClearOfAllSolids) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    const Pose pose = scene->compute_pose(0.0);
    const std::vector<Camera>& cameras = scene->get_walkthrough().cameras;
    ASSERT_EQ(cameras.size(), 120u);
    // A corner of the near plane at 16:9 and 65 degrees is 1.7 times as far as the plane.
    const double clear = 2.0 * cameras.front().near_m;
    for (std::size_t frame = 0; frame < cameras.size(); frame += 3) {
        const glm::dvec3& eye = cameras[frame].position;
        const Clearance clearance =
            measure_clearance(collect_triangles_near(*scene, pose, eye, 0.5), eye);
        EXPECT_GT(clearance.distance_m, clear) << "frame " << frame;
        EXPECT_FALSE(clearance.inside) << "frame " << frame << " inside "
                                       << scene->get_objects()[clearance.inside.value_or(0)].name;
    }
}

TEST(Cathedral, HasTheSizeOfAChurch) {
    glm::dvec3 low(1e9);
    glm::dvec3 high(-1e9);
    const std::unique_ptr<Scene> scene = open("1");
    for (const Triangle& triangle : collect_triangles(*scene, scene->compute_pose(0.0))) {
        for (const glm::dvec3& corner : triangle.corners) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
    }
    EXPECT_NEAR(high.x - low.x, 37.0, 1.5);
    EXPECT_NEAR(high.y, 14.9, 0.3);
    EXPECT_NEAR(high.z - low.z, 19.4, 0.5);
}

} // namespace
} // namespace alcove
