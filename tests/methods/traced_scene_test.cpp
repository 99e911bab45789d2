#include "methods/common/traced_scene.hpp"

#include "tests/test_scenes.hpp"

#include <random>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

/// A sphere placed many times, turned and stretched, and a box; one sphere moves.
struct Crowd {
    std::vector<Mesh> meshes{make_sphere({0.0f, 0.0f, 0.0f}, 0.5f, 8),
                             make_box({-6.0f, -2.0f, -6.0f}, {6.0f, -1.0f, 6.0f})};

    [[nodiscard]] PosedGeometry pose(double time_s) const {
        PosedGeometry geometry;
        geometry.is_static = false;
        geometry.time_s = time_s;
        for (int i = 0; i < 24; ++i) {
            glm::dmat4 placing =
                glm::translate(glm::dmat4(1.0),
                               glm::dvec3(i % 5 - 2, 0.3 * (i % 3), i / 5 - 2 + time_s * (i == 7)));
            placing = glm::scale(glm::rotate(placing, 0.4 * i, glm::dvec3(0.0, 0.6, 0.8)),
                                 glm::dvec3(0.9, 0.5 + 0.05 * i, 0.7));
            PosedObject& object = geometry.objects.emplace_back();
            object.mesh = &meshes[0];
            object.motion = i == 7 ? ObjectMotion::rigid : ObjectMotion::still;
            object.origin_from_object = glm::mat4(placing);
        }
        PosedObject& floor = geometry.objects.emplace_back();
        floor.mesh = &meshes[1];
        floor.motion = ObjectMotion::still;
        return geometry;
    }
};

struct Hit {
    float distance = 0.0f;
    glm::vec3 point{0.0f}; ///< by the triangle's corners
    glm::vec3 normal{0.0f};
};

std::optional<Hit> trace(const TracedScene& scene, const glm::vec3& from, const glm::vec3& way) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray.org_x = from.x;
    query.ray.org_y = from.y;
    query.ray.org_z = from.z;
    query.ray.dir_x = way.x;
    query.ray.dir_y = way.y;
    query.ray.dir_z = way.z;
    query.ray.tfar = 100.0f;
    query.ray.mask = 0xffffffffu;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene.top(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return std::nullopt;
    }
    const TracedTriangle triangle =
        scene.get_triangle({query.hit.instID[0], query.hit.geomID, query.hit.primID});
    const float u = query.hit.u;
    const float v = query.hit.v;
    return Hit{query.ray.tfar,
               (1.0f - u - v) * triangle.corners[0] + u * triangle.corners[1] +
                   v * triangle.corners[2],
               triangle.normals[0]};
}

TEST(TracedSceneTest, InstancesGiveWhatCopiesGiveAndBothFollowTheMover) {
    const Crowd crowd;
    TracedScene copies;
    TracedScene instances(1);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    int hits = 0;
    int moved = 0;
    std::vector<float> first_distances;
    for (const double time_s : {0.0, 0.5, 1.5}) {
        const PosedGeometry geometry = crowd.pose(time_s);
        copies.update(geometry);
        instances.update(geometry);
        std::mt19937 rays(9);
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 from(0.0f, 5.0f, 8.0f);
            const glm::vec3 to(4.0f * unit(rays), 2.0f * unit(rays), 4.0f * unit(rays));
            const glm::vec3 way = glm::normalize(to - from);
            const auto a = trace(copies, from, way);
            const auto b = trace(instances, from, way);
            const float distance = a ? a->distance : -1.0f;
            if (time_s == 0.0) {
                first_distances.push_back(distance);
            } else {
                moved += std::abs(distance - first_distances[static_cast<std::size_t>(i)]) > 0.01f;
            }
            // A ray past an edge may fall on either side of it.
            if (!a || !b || std::abs(a->distance - b->distance) > 1e-3f) {
                continue;
            }
            ++hits;
            EXPECT_NEAR(glm::distance(a->point, from + a->distance * way), 0.0f, 2e-5f);
            EXPECT_NEAR(glm::distance(b->point, from + b->distance * way), 0.0f, 2e-5f);
            EXPECT_NEAR(glm::distance(a->normal, b->normal), 0.0f, 1e-4f);
        }
    }
    EXPECT_GT(hits, 4000);
    EXPECT_GT(moved, 20);
}

} // namespace
} // namespace alcove
