#include "scenes/city/city.hpp"

#include "core/base/error.hpp"
#include "scenes/city/movers.hpp"
#include "scenes/city/plan.hpp"
#include "tests/scenes/solid_check.hpp"
#include "tests/scenes/space_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Scene> open(const std::string& detail, const std::string& seed = "1",
                            const std::string& walkthrough = "default") {
    const SceneUnit unit = city_unit();
    const std::vector<ParameterOverride> overrides{
        {"detail", detail}, {"seed", seed}, {"walkthrough", walkthrough}};
    return unit.open(unit.parameters.resolve(overrides, {}));
}

/// The ridge of the highest house, raised.
constexpr double kHighestRidge =
    city::kPavement + city::get_wall_height(city::kHighestHouse) + city::kRoofRise + 0.22;

/// 0.5 has a single layer of every moulding, 4 two of them.
class CityDetail : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Layers, CityDetail, testing::Values("0.5", "4"), [](const auto& tested) {
    return tested.param == std::string("4") ? "Two" : "One";
});

TEST_P(CityDetail, EveryMeshIsMadeOfWatertightSolidsTurnedOutward) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    check_scene(*scene, "city");
    for (const Mesh& mesh : scene->get_meshes()) {
        const SolidCheck check = check_solid(mesh);
        EXPECT_EQ(check.open_edges, 0u) << mesh.name;
        EXPECT_GT(check.volume, 1e-6) << mesh.name;
    }
}

TEST_P(CityDetail, NoTwoSolidsShareAFaceNearTheStreet) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    const glm::dvec3 corner(-127.0, 1.7, 7.5); // with a crossing, end walls and figures
    EXPECT_EQ(list_shared_faces(
                  *scene, collect_triangles_near(*scene, scene->compute_pose(2.0), corner, 9.0)),
              "");
}

TEST(City, GrowsWithDetailFromAQuarterToTwentyTwoMillionVertices) {
    const std::unique_ptr<Scene> standard = open("1");
    EXPECT_GE(count_size(*standard).vertices, 200'000u);
    EXPECT_LE(count_size(*standard).vertices, 350'000u);
    EXPECT_LT(standard->get_objects().size(), 6'000u);
    std::size_t before = 0;
    for (const char* detail : {"0.5", "0.7", "1", "2", "4", "8", "16", "32", "64"}) {
        const std::size_t vertices = count_size(*open(detail)).vertices;
        EXPECT_GT(vertices, before) << detail;
        before = vertices;
    }
    constexpr double kVienna = 21'934'980.0; // TSSAO, table 2
    EXPECT_GE(static_cast<double>(before), kVienna);
    EXPECT_LE(static_cast<double>(before), 1.03 * kVienna);
    EXPECT_LT(open("64")->get_objects().size(), 80'000u);
}

TEST(City, HasItsExtentAndItsHousesAtEveryDetail) {
    const std::unique_ptr<Scene> coarse = open("0.5");
    const std::unique_ptr<Scene> fine = open("8");
    const auto list_houses = [](const Scene& scene) {
        const Pose pose = scene.compute_pose(0.0);
        std::vector<std::array<double, 3>> places;
        for (std::size_t i = 0; i < scene.get_objects().size(); ++i) {
            if (scene.get_objects()[i].name.rfind("house#", 0) == 0) {
                const glm::dvec4& place = pose.object_to_world[i][3];
                places.push_back({place.x, place.y, place.z});
            }
        }
        return places;
    };
    const auto houses = list_houses(*coarse);
    EXPECT_EQ(houses, list_houses(*fine));
    const auto [west, east] = std::minmax_element(houses.begin(), houses.end());
    EXPECT_NEAR((*east)[0] - (*west)[0], 1170.0, 20.0);
}

TEST(City, IsDecidedByItsParametersAlone) {
    const std::string hash = hash_geometry(*open("0.5"), 0.0);
    EXPECT_EQ(hash, hash_geometry(*open("0.5"), 0.0));
    EXPECT_NE(hash, hash_geometry(*open("0.5", "2"), 0.0));
    EXPECT_NE(hash, hash_geometry(*open("0.6"), 0.0));
    EXPECT_THROW(static_cast<void>(open("65")), InputError);
}

class CityWalkthrough : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, CityWalkthrough, testing::Values("default", "full"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(CityWalkthrough, TheCameraStaysClearOfAllSolids) {
    const std::unique_ptr<Scene> scene = open("4", "1", GetParam());
    const Walkthrough& walkthrough = scene->get_walkthrough();
    const std::size_t frames = walkthrough.cameras.size();
    const std::size_t stride = frames / 40;
    for (std::size_t frame = 0; frame < frames; frame += stride) {
        const Pose pose = scene->compute_pose(static_cast<double>(frame) * walkthrough.step_s);
        const glm::dvec3& eye = walkthrough.cameras[frame].position;
        const Clearance clearance =
            measure_clearance(collect_triangles_near(*scene, pose, eye, 0.5), eye);
        EXPECT_GT(clearance.distance_m, 0.3) << "frame " << frame;
        EXPECT_FALSE(clearance.inside) << "frame " << frame << " inside "
                                       << scene->get_objects()[clearance.inside.value_or(0)].name;
    }
}

TEST_P(CityWalkthrough, ShowsMoreThanAKilometreFromAboveTheRoofs) {
    const std::unique_ptr<Scene> scene = open("0.5", "1", GetParam());
    const Walkthrough& walkthrough = scene->get_walkthrough();
    const Pose pose = scene->compute_pose(0.0);
    int above = 0;
    double farthest = 0.0;
    for (const Camera& camera : walkthrough.cameras) {
        EXPECT_LE(camera.near_m, 0.2);
        EXPECT_GE(camera.far_m, 1500.0);
        if (camera.position.y < kHighestRidge) {
            continue;
        }
        ++above;
        if (above % 10 != 1) {
            continue;
        }
        // The camera looks along its -z; a house counts that stands in the middle of the image.
        for (std::size_t i = 0; i < pose.object_to_world.size(); ++i) {
            const glm::dvec3 away = glm::dvec3(pose.object_to_world[i][3]) - camera.position;
            const glm::dvec3 in_view = glm::transpose(camera.world_from_view) * away;
            if (std::abs(in_view.x) < -0.4 * in_view.z && std::abs(in_view.y) < -0.3 * in_view.z) {
                farthest = std::max(farthest, -in_view.z);
            }
        }
    }
    EXPECT_GE(above, 30);
    EXPECT_GT(farthest, 1000.0);
}

TEST(City, OnlyTrafficMoves) {
    const std::unique_ptr<Scene> scene = open("0.5");
    const Pose before = scene->compute_pose(0.0);
    const Pose after = scene->compute_pose(1.0);
    EXPECT_FALSE(scene->is_static());
    int cars = 0;
    int wheels = 0;
    int limbs = 0;
    for (std::size_t i = 0; i < before.object_to_world.size(); ++i) {
        if (before.object_to_world[i] == after.object_to_world[i]) {
            continue;
        }
        const std::string& name = scene->get_objects()[i].name;
        const auto starts_with = [&name](const char* start) { return name.rfind(start, 0) == 0; };
        cars += starts_with("car#") || starts_with("tram#") ? 1 : 0;
        wheels += starts_with("wheel#") ? 1 : 0;
        limbs += starts_with("figure_") ? 1 : 0;
        EXPECT_TRUE(starts_with("car") || starts_with("tram") || starts_with("wheel#") ||
                    starts_with("figure_"))
            << name;
        const glm::dvec3 way(after.object_to_world[i][3] - before.object_to_world[i][3]);
        EXPECT_LT(glm::length(way), 10.0) << name;
    }
    EXPECT_GE(cars, 20);
    EXPECT_GE(wheels, 4 * 20);
    EXPECT_GE(limbs, 12 * 12);
}

/// Objects of one figure are placed one after the other: both feet of a figure are neighbours.
std::vector<std::size_t> list_feet(const Scene& scene) {
    std::vector<std::size_t> feet;
    for (std::size_t i = 0; i < scene.get_objects().size(); ++i) {
        if (scene.get_objects()[i].name.rfind("figure_foot#", 0) == 0) {
            feet.push_back(i);
        }
    }
    return feet;
}

double find_lowest(const Mesh& mesh, const glm::dmat4& transform) {
    double lowest = 1e30;
    for (const glm::vec3& position : mesh.positions) {
        lowest = std::min(lowest, (transform * glm::dvec4(glm::dvec3(position), 1.0)).y);
    }
    return lowest;
}

TEST(City, FiguresStandOnThePavementAndDoNotSlide) {
    const std::unique_ptr<Scene> scene = open("0.5");
    const std::vector<std::size_t> feet = list_feet(*scene);
    ASSERT_GE(feet.size(), 2u * 12u);
    for (int frame = 0; frame < 120; frame += 5) {
        const Pose now = scene->compute_pose(frame / 30.0);
        const Pose next = scene->compute_pose((frame + 1) / 30.0);
        for (std::size_t i = 0; i < feet.size(); i += 2) {
            double lowest = 1e30;
            double slide = 1e30; // of the foot that stands
            for (const std::size_t foot : {feet[i], feet[i + 1]}) {
                const Mesh& mesh = scene->get_meshes()[scene->get_objects()[foot].mesh];
                lowest = std::min(lowest, find_lowest(mesh, now.object_to_world[foot]));
                slide = std::min(slide, glm::length(glm::dvec3(next.object_to_world[foot][3] -
                                                               now.object_to_world[foot][3])));
            }
            EXPECT_NEAR(lowest, city::kPavement, 0.02) << "frame " << frame;
            EXPECT_LT(slide, 1e-3) << "frame " << frame;
        }
    }
}

TEST(City, LimbsOfAFigureStayTogether) {
    const std::unique_ptr<Scene> scene = open("0.5");
    for (int frame = 0; frame < 60; ++frame) {
        const Pose pose = scene->compute_pose(frame / 30.0);
        for (std::size_t i = 0; i + 1 < pose.object_to_world.size(); ++i) {
            if (scene->get_objects()[i].name.rfind("figure_shin#", 0) != 0) {
                continue;
            }
            // A foot follows its shin after the other shin.
            const glm::dvec3 ankle(pose.object_to_world[i] *
                                   glm::dvec4(0.0, -city::kBody.shin_length, 0.0, 1.0));
            const glm::dvec3 foot(pose.object_to_world[i + 2][3]);
            EXPECT_LT(glm::distance(ankle, foot), 0.01) << "frame " << frame;
        }
    }
}

} // namespace
} // namespace alcove
