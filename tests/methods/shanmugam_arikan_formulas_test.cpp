// The far part's formulas in double: solid angles, reach, bounds, clusters.
#include "core/base/cache_folder.hpp"
#include "core/base/file.hpp"
#include "methods/shanmugam_arikan/lloyd.hpp"
#include "methods/shanmugam_arikan/sphere_clusters.hpp"
#include "methods/shanmugam_arikan/sphere_occlusion.hpp"
#include "tests/methods/analytic_occlusion.hpp"
#include "tests/test_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(CapSolidAngle, IsThePrintedOneWithoutItsCancellation) {
    for (const double t : {0.9, 0.5, 0.1, 0.01}) {
        const double printed = 2.0 * kPi * (1.0 - std::cos(std::asin(t)));
        EXPECT_NEAR(compute_cap_solid_angle(t, 1.0), printed, 1e-10 * printed + 1e-15) << t;
    }
    // At 1e-9 the printed form gives 0; the cap is pi t^2.
    EXPECT_EQ(1.0 - std::cos(std::asin(1e-9)), 0.0);
    EXPECT_NEAR(compute_cap_solid_angle(1e-9, 1.0) / (kPi * 1e-18), 1.0, 1e-12);
    EXPECT_DOUBLE_EQ(compute_cap_solid_angle(1.0, 1.0), 2.0 * kPi);
    EXPECT_DOUBLE_EQ(compute_cap_solid_angle(3.0, 1.0), 2.0 * kPi);
}

TEST(SphereOcclusion, OverPiIsTheExactOneForSmallSpheresAndTwiceItAtContact) {
    const glm::dvec3 normal(0.0, 0.0, 1.0);
    for (const double t : {0.001, 0.1, 0.3, 0.6}) {
        const double sine = std::min(0.9, std::sqrt(1.0 - t * t)); // wholly above the horizon
        const glm::dvec3 to_center(std::sqrt(1.0 - sine * sine), 0.0, sine);
        const double exact = compute_sphere_occlusion(to_center, t);
        const double ratio = compute_sphere_occlusion_sr(to_center, t, normal) / kPi / exact;
        EXPECT_NEAR(ratio, 2.0 / (1.0 + std::sqrt(1.0 - t * t)), 1e-9) << t;
    }
    EXPECT_EQ(compute_sphere_occlusion_sr({1.0, 0.0, -0.5}, 0.2, normal), 0.0);
}

TEST(FarDistance, MatchesItsTableAndReachesExactlyEpsilon) {
    struct Row {
        double epsilon;
        double radii;
    };
    for (const Row& row : {Row{0.5, 2.558},
                           {0.1, 5.627},
                           {0.05, 7.942},
                           {0.01, 17.73},
                           {0.005, 25.07},
                           {0.001, 56.05}}) {
        const double distance = compute_far_distance_in_radii(row.epsilon);
        EXPECT_NEAR(distance, row.radii, 5e-4 * row.radii) << row.epsilon;
        const double printed = 1.0 / std::sin(std::acos(1.0 - row.epsilon / (2.0 * kPi)));
        EXPECT_NEAR(distance, printed, 1e-9 * printed);
        EXPECT_NEAR(compute_cap_solid_angle(1.0, distance), row.epsilon, 1e-12);
    }
    EXPECT_DOUBLE_EQ(compute_far_distance_in_radii(2.0 * kPi), 1.0);
    EXPECT_DEATH(static_cast<void>(compute_far_distance_in_radii(0.0)), "hemisphere");
    EXPECT_DEATH(static_cast<void>(compute_far_distance_in_radii(6.3)), "hemisphere");
}

TEST(BallBounds, HoldEveryPointOfTheBallAndTouchIt) {
    const glm::dvec2 tangents(0.8, 0.6);
    std::minstd_rand random(5);
    const auto draw = [&random] { return static_cast<double>(random() % 20011u) / 20011.0; };
    for (int ball = 0; ball < 40; ++ball) {
        const glm::dvec3 center(4.0 * draw() - 2.0, 3.0 * draw() - 1.5, -1.0 - 6.0 * draw());
        const double radius = 0.1 + 0.7 * draw();
        const DeviceRectangle bounds = compute_ball_bounds(center, radius, tangents);
        glm::dvec2 low(INFINITY);
        glm::dvec2 high(-INFINITY);
        for (int i = 0; i < 40000; ++i) {
            const double z = 2.0 * draw() - 1.0;
            const double azimuth = 2.0 * kPi * draw();
            const double s = std::sqrt(1.0 - z * z);
            const glm::dvec3 p =
                center + radius * glm::dvec3(s * std::cos(azimuth), s * std::sin(azimuth), z);
            const glm::dvec2 ndc = glm::dvec2(p) / -p.z / tangents;
            low = glm::min(low, ndc);
            high = glm::max(high, ndc);
        }
        for (int axis = 0; axis < 2; ++axis) {
            const double clipped_low = std::clamp(low[axis], -1.0, 1.0);
            const double clipped_high = std::clamp(high[axis], -1.0, 1.0);
            const double size = high[axis] - low[axis];
            EXPECT_LE(bounds.low[axis], clipped_low + 1e-12) << ball;
            EXPECT_GE(bounds.high[axis], clipped_high - 1e-12) << ball;
            EXPECT_NEAR(bounds.low[axis], clipped_low, 0.01 * size) << ball;
            EXPECT_NEAR(bounds.high[axis], clipped_high, 0.01 * size) << ball;
        }
    }
    EXPECT_TRUE(compute_ball_bounds({0.0, 0.0, 2.0}, 1.0, tangents).is_empty());
    const DeviceRectangle around = compute_ball_bounds({0.3, 0.0, -0.5}, 1.0, tangents);
    EXPECT_EQ(around.low, glm::dvec2(-1.0));
    EXPECT_EQ(around.high, glm::dvec2(1.0));
}

std::vector<glm::vec3> draw_points(std::size_t count, unsigned seed) {
    std::minstd_rand random(seed);
    const auto draw = [&random] { return static_cast<float>(random() % 10007u) / 10007.0f; };
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < count; ++i) {
        points.emplace_back(3.0f * draw(), draw(), i % 2 == 0 ? 0.0f : draw());
    }
    return points;
}

TEST(Lloyd, SeparatesClumpsAndOwnersAreNearest) {
    const std::vector<glm::vec3> points = draw_points(3000, 3);
    const std::size_t count = 60;
    double before = std::numeric_limits<double>::infinity();
    for (const int iterations : {1, 2, 4, 8}) {
        const std::vector<std::uint32_t> owners = cluster_points(points, count, iterations);
        std::vector<glm::dvec3> sums(count, glm::dvec3(0.0));
        std::vector<int> counts(count, 0);
        for (std::size_t i = 0; i < points.size(); ++i) {
            ASSERT_LT(owners[i], count);
            sums[owners[i]] += glm::dvec3(points[i]);
            ++counts[owners[i]];
        }
        double squares = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec3 off =
                glm::dvec3(points[i]) - sums[owners[i]] / static_cast<double>(counts[owners[i]]);
            squares += glm::dot(off, off);
        }
        EXPECT_LE(squares, before) << iterations << " rounds";
        before = squares;
    }
    // One round from known centres: brute force over all of them.
    const std::vector<std::uint32_t> owners = cluster_points(points, count, 1);
    std::vector<glm::vec3> centers;
    for (std::size_t i = 0; i < count; ++i) {
        centers.push_back(points[(2 * i + 1) * points.size() / (2 * count)]);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto nearest =
            std::min_element(centers.begin(), centers.end(), [&](const auto& a, const auto& b) {
                return glm::distance(points[i], a) < glm::distance(points[i], b);
            });
        EXPECT_FLOAT_EQ(glm::distance(points[i], *nearest),
                        glm::distance(points[i], centers[owners[i]]));
    }
}

TEST(Clusters, CoverTheirMembersAndFollowThePose) {
    const TestScene scene = make_box_scene();
    const PosedGeometry rest = pose_geometry(scene, 0.0);
    const ClusterSet set = find_clusters(rest, {200, SphereMembers::surface});
    EXPECT_NEAR(static_cast<double>(set.clusters.size()), 200.0, 20.0);
    SpherePoser covering(set, RadiusRule::covering, 0.0);
    SpherePoser ball(set, RadiusRule::rms_ball, 0.0);
    SpherePoser disc(set, RadiusRule::rms_disc, 0.0);
    SpherePoser silhouette(set, RadiusRule::silhouette, 0.0);
    const std::vector<Sphere> spheres = covering.pose(rest);
    const std::vector<Sphere> balls = ball.pose(rest);
    const std::vector<Sphere> discs = disc.pose(rest);
    const std::vector<Sphere> silhouettes = silhouette.pose(rest);
    for (std::size_t i = 0; i < set.clusters.size(); ++i) {
        const SphereCluster& cluster = set.clusters[i];
        const PosedObject& object = rest.objects[cluster.object];
        double squares = 0.0;
        for (std::uint32_t m = cluster.first; m < cluster.first + cluster.count; ++m) {
            const ClusterMember& member = set.members[m];
            const auto corner = [&](std::uint32_t k) {
                return object.positions()[object.mesh->indices[member.triangle + k]];
            };
            const glm::vec3 local =
                corner(0) + member.u * (corner(1) - corner(0)) + member.v * (corner(2) - corner(0));
            const glm::vec3 place(object.origin_from_object * glm::vec4(local, 1.0f));
            const float distance = glm::distance(place, spheres[i].center);
            EXPECT_LE(distance, spheres[i].radius * 1.0001f + 1e-5f);
            squares += static_cast<double>(distance * distance);
        }
        const double rms = std::sqrt(squares / cluster.count);
        EXPECT_NEAR(balls[i].radius, rms * std::sqrt(5.0 / 3.0), 1e-3 * rms + 1e-6);
        EXPECT_NEAR(discs[i].radius, rms * std::sqrt(2.0), 1e-3 * rms + 1e-6);
        // A quarter of the disc's area: mean silhouette of a convex body over its surface.
        EXPECT_NEAR(std::pow(silhouettes[i].radius / discs[i].radius, 2.0), 0.25, 1e-4);
    }
    // Pushed back by up to a radius, against the normal.
    SpherePoser pushed(set, RadiusRule::covering, 1.0);
    const std::vector<Sphere> behind = pushed.pose(rest);
    int planar = 0;
    for (std::size_t i = 0; i < behind.size(); ++i) {
        const float distance = glm::distance(behind[i].center, spheres[i].center);
        EXPECT_LE(distance, 1.001f * spheres[i].radius);
        planar += distance > 0.99f * spheres[i].radius ? 1 : 0;
    }
    EXPECT_GT(planar, 100) << "most of the scene is floor and boxes";
    PosedGeometry moved = rest;
    for (PosedObject& object : moved.objects) {
        object.origin_from_object[3] += glm::vec4(1.0f, 2.0f, 3.0f, 0.0f);
    }
    const std::vector<Sphere> after = covering.pose(moved);
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_LT(glm::distance(after[i].center, spheres[i].center + glm::vec3(1.0f, 2.0f, 3.0f)),
                  1e-5f);
    }
}

TEST(Clusters, AreFoundOnceAndADamagedFileIsMadeAnew) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / "alcove_cluster_cache_test";
    std::filesystem::remove_all(folder);
    ASSERT_EQ(setenv("ALCOVE_CACHE", folder.c_str(), 1), 0);
    const TestScene scene = make_box_scene();
    const PosedGeometry rest = pose_geometry(scene, 0.0);
    const ClusterSettings settings{100, SphereMembers::vertices};
    const ClusterSet first = get_clusters(rest, settings);
    std::filesystem::path file;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        file = entry.is_regular_file() ? entry.path() : file;
    }
    ASSERT_FALSE(file.empty());
    const std::string bytes = read_file(file);
    const auto expect_same = [&](const ClusterSet& set) {
        ASSERT_EQ(set.clusters.size(), first.clusters.size());
        ASSERT_EQ(set.members.size(), first.members.size());
        for (std::size_t i = 0; i < set.members.size(); ++i) {
            EXPECT_EQ(set.members[i].triangle, first.members[i].triangle);
        }
    };
    expect_same(get_clusters(rest, settings));
    for (const std::string& damaged :
         {bytes.substr(0, bytes.size() / 2), bytes + "x", std::string("short"),
          bytes.substr(0, 40) + std::string(16, '\xff') + bytes.substr(56)}) {
        write_cache_file(file, damaged);
        expect_same(get_clusters(rest, settings));
        EXPECT_EQ(read_file(file), bytes);
    }
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace alcove
