#include "scenes/paladin/paladin.hpp"

#include "scenes/common/knight.hpp"
#include "tests/scenes/deforming_check.hpp"
#include "tests/scenes/solid_check.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr double kPeriod_s = 12.0; ///< once around the circle

std::unique_ptr<Scene> open(const std::string& detail, const std::string& walkthrough = "default",
                            const std::string& seed = "1") {
    const SceneUnit unit = paladin_unit();
    const std::vector<ParameterOverride> overrides{
        {"detail", detail}, {"walkthrough", walkthrough}, {"seed", seed}};
    return unit.open(unit.parameters.resolve(overrides, {}));
}

std::size_t find_object(const Scene& scene, const std::string& part) {
    const std::vector<std::size_t> found = find_objects(scene, part);
    EXPECT_FALSE(found.empty()) << part;
    return found.at(0);
}

TEST(Paladin, EverySolidStaysClosedAndItsNormalsLookOutwardWhileItMoves) {
    const std::unique_ptr<Scene> scene = open("0.25");
    for (const double time_s : {0.0, 0.37, 1.15, 5.9}) {
        for (std::size_t i = 0; i < scene->get_objects().size(); ++i) {
            const Mesh mesh = pose_mesh(*scene, i, time_s);
            const SolidCheck check = check_solid(mesh);
            EXPECT_EQ(check.open_edges, 0u) << scene->get_objects()[i].name << " at " << time_s;
            EXPECT_GT(check.volume, 1e-6) << scene->get_objects()[i].name << " at " << time_s;
            // A cloth's crease may be sharper than its cells.
            EXPECT_LE(count_inverted_corners(mesh), mesh.indices.size() / 500)
                << scene->get_objects()[i].name << " at " << time_s;
        }
    }
}

TEST(Paladin, HasAsManyVerticesAsPromised) {
    const std::size_t vertices = count_size(*open("1")).vertices;
    EXPECT_GE(vertices, 30'000u);
    EXPECT_LE(vertices, 60'000u);
    EXPECT_GT(count_size(*open("2")).vertices, vertices * 17 / 10);
}

TEST(Paladin, FeetStandWithoutSliding) {
    const std::unique_ptr<Scene> scene = open("0.06");
    const std::vector<std::size_t> boots = find_objects(*scene, "boot");
    ASSERT_EQ(boots.size(), 2u);
    const FootCheck check = check_feet(*scene, boots[0], boots[1], 0, 120);
    EXPECT_LT(check.slide_m, 1e-4);
    EXPECT_NEAR(check.highest_m, 0.0, 0.002);
    EXPECT_GT(check.lowest_m, -0.05);
}

TEST(Paladin, WalksInALoop) {
    const std::unique_ptr<Scene> scene = open("0.06");
    const std::size_t cloak = find_object(*scene, "paladin cloak");
    const std::size_t body = find_object(*scene, "paladin body");
    for (const double time_s : {0.0, 1.9}) {
        for (const std::size_t object : {cloak, body}) {
            const Mesh now = pose_mesh(*scene, object, time_s);
            const Mesh later = pose_mesh(*scene, object, time_s + kPeriod_s);
            const Mesh half = pose_mesh(*scene, object, time_s + 0.5 * kPeriod_s);
            for (std::size_t i = 0; i < now.positions.size(); ++i) {
                ASSERT_LT(glm::distance(now.positions[i], later.positions[i]), 1e-5f);
            }
            EXPECT_GT(glm::distance(now.positions[0], half.positions[0]), 3.0f);
        }
    }
}

/// The second difference of a smooth motion falls with the square of the step.
TEST(Paladin, ClothAndBodyMoveSmoothly) {
    const std::unique_ptr<Scene> scene = open("0.1");
    for (const char* name : {"paladin cloak", "paladin body"}) {
        const std::size_t object = find_object(*scene, name);
        for (const double time_s : {0.4, 2.3}) {
            const double h = 1.0 / 480.0;
            const Mesh before = pose_mesh(*scene, object, time_s - h);
            const Mesh now = pose_mesh(*scene, object, time_s);
            const Mesh after = pose_mesh(*scene, object, time_s + h);
            double fastest = 0.0;
            for (std::size_t i = 0; i < now.positions.size(); ++i) {
                const glm::dvec3 a(now.positions[i] - before.positions[i]);
                const glm::dvec3 b(after.positions[i] - now.positions[i]);
                fastest = std::max(fastest, glm::length(b) / h);
                ASSERT_LT(glm::distance(a, b), 120.0 * h * h) << name << ", vertex " << i;
            }
            EXPECT_GT(fastest, 0.8) << name; // it walks
            EXPECT_LT(fastest, 5.0) << name;
        }
    }
}

TEST(Paladin, TheCloakMovesAgainstItsWearer) {
    const std::unique_ptr<Scene> scene = open("0.1");
    const std::size_t cloak = find_object(*scene, "paladin cloak");
    const Deformation first = scene->deform(cloak, 0.0);
    double largest = 0.0;
    for (int frame = 1; frame < 30; ++frame) {
        const Deformation next = scene->deform(cloak, frame / 30.0);
        for (std::size_t i = 0; i < first.positions.size(); ++i) {
            largest = std::max(
                largest, static_cast<double>(glm::distance(first.positions[i], next.positions[i])));
        }
    }
    EXPECT_GT(largest, 0.15);
    EXPECT_LT(largest, 0.5);
}

double measure_distance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const double s = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::distance(p, a + s * (b - a));
}

TEST(Paladin, TheCloakStaysClearOfTheLegs) {
    const std::unique_ptr<Scene> scene = open("0.1");
    const std::size_t cloak = find_object(*scene, "paladin cloak");
    const WalkerBody& body = get_knight_body();
    const std::vector<std::size_t> greaves = find_objects(*scene, "greave"); // on the shins
    ASSERT_EQ(greaves.size(), 2u);
    for (int frame = 0; frame < 60; ++frame) {
        const double time_s = frame / 30.0;
        const Mesh cloth = pose_mesh(*scene, cloak, time_s);
        const Pose pose = scene->compute_pose(time_s);
        for (const std::size_t greave : greaves) {
            const glm::dmat4& shin = pose.object_to_world[greave];
            const glm::dvec3 knee(shin[3]);
            const glm::dvec3 ankle(shin * glm::dvec4(0.0, -body.shin_length, 0.0, 1.0));
            for (const glm::vec3& position : cloth.positions) {
                ASSERT_GT(measure_distance(glm::dvec3(position), knee, ankle), 0.12)
                    << "frame " << frame;
            }
        }
    }
}

class PaladinWalkthrough : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, PaladinWalkthrough, testing::Values("default", "walk"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(PaladinWalkthrough, TheCameraStaysClearOfAllSolids) {
    const std::unique_ptr<Scene> scene = open("0.06", GetParam());
    EXPECT_GT(measure_camera_clearance(*scene, 12), 0.3);
}

TEST(Paladin, HasMovingAndStillCamerasAndALongClip) {
    const std::unique_ptr<Scene> scene = open("0.06");
    const std::vector<Camera>& cameras = scene->get_walkthrough().cameras;
    ASSERT_EQ(cameras.size(), 120u);
    EXPECT_NE(cameras[0].position, cameras[40].position);
    for (std::size_t frame = 84; frame < 120; ++frame) {
        EXPECT_EQ(cameras[frame].position, cameras[84].position);
    }
    EXPECT_EQ(open("0.06", "walk")->get_walkthrough().cameras.size(), 300u);
}

TEST(Paladin, IsDecidedByItsParametersAndTheTime) {
    const std::string hash = hash_geometry(*open("0.06"), 0.5);
    EXPECT_EQ(hash, hash_geometry(*open("0.06"), 0.5));
    EXPECT_NE(hash, hash_geometry(*open("0.06"), 0.6));
    EXPECT_NE(hash, hash_geometry(*open("0.06", "default", "2"), 0.5));
}

} // namespace
} // namespace alcove
