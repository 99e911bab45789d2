#include "scenes/common/clusters.hpp"

#include "scenes/common/solids.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

/// A torus of 2 x 120 x 40 triangles.
Mesh make_ring() {
    std::vector<Ring> rings;
    for (int i = 0; i < 120; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / 120;
        Ring& ring = rings.emplace_back();
        for (int k = 0; k < 40; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / 40;
            const double radius = 2.0 + 0.7 * std::cos(angle);
            ring.emplace_back(radius * std::cos(turn), 0.7 * std::sin(angle),
                              radius * std::sin(turn));
        }
    }
    MeshBuilder builder;
    add_loft(builder, rings, LoftEnds::joined);
    return builder.finish("ring", glm::vec3(0.5f), 180.0);
}

using Triangle = std::array<std::uint32_t, 3>;

std::vector<Triangle> list_triangles(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        Triangle triangle{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                    triangle.end());
        triangles.push_back(triangle);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

TEST(ClustersTest, TheyPartitionTheSameTrianglesAndHoldThemInTheirBoxes) {
    const Mesh before = make_ring();
    ASSERT_TRUE(before.closed);
    Mesh mesh = before;
    build_clusters(mesh);
    EXPECT_EQ(list_triangles(mesh), list_triangles(before));
    ASSERT_GT(mesh.clusters.size(), 9600u / 256u);
    std::size_t next = 0;
    for (const Cluster& cluster : mesh.clusters) {
        EXPECT_EQ(cluster.first_index, next);
        next += cluster.index_count;
        for (std::size_t i = cluster.first_index; i < next; ++i) {
            const glm::vec3 p = mesh.positions[mesh.indices[i]];
            EXPECT_TRUE(glm::all(glm::lessThanEqual(cluster.low, p)));
            EXPECT_TRUE(glm::all(glm::lessThanEqual(p, cluster.high)));
        }
    }
    EXPECT_EQ(next, mesh.indices.size());
}

TEST(ClustersTest, AClusterWhoseConeFacesAwayHasNoTriangleThatFacesTheEye) {
    Mesh mesh = make_ring();
    build_clusters(mesh);
    int away = 0;
    for (int i = 0; i < 64; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 64;
        const glm::vec3 eye(7.0 * std::cos(angle), 5.0 * std::sin(3.0 * angle),
                            7.0 * std::sin(angle));
        for (const Cluster& cluster : mesh.clusters) {
            const glm::vec3 way = glm::normalize(cluster.cone_apex - eye);
            if (!(cluster.cone_cutoff < 1.0f) ||
                glm::dot(way, cluster.cone_axis) < cluster.cone_cutoff) {
                continue;
            }
            ++away;
            for (std::size_t k = 0; k < cluster.index_count; k += 3) {
                const auto corner = [&](std::size_t place) {
                    return mesh.positions[mesh.indices[cluster.first_index + k + place]];
                };
                const glm::vec3 normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
                EXPECT_LE(glm::dot(normal, eye - corner(0)), 1e-6f);
            }
        }
    }
    EXPECT_GT(away, 100);
}

TEST(ClustersTest, SmallMeshesStayWhole) {
    MeshBuilder builder;
    add_box(builder, glm::dvec3(-1.0), glm::dvec3(1.0));
    Mesh mesh = builder.finish("box", glm::vec3(0.5f), 0.0);
    const std::vector<std::uint32_t> indices = mesh.indices;
    build_clusters(mesh);
    EXPECT_TRUE(mesh.clusters.empty());
    EXPECT_EQ(mesh.indices, indices);
    EXPECT_TRUE(mesh.closed);
}

TEST(ClustersTest, AMeshWithAHoleOrTurnedInsideOutIsNotClosed) {
    MeshBuilder open;
    for (const glm::dvec3& point :
         {glm::dvec3(0, 0, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
        open.add_point(point);
    }
    open.add_triangle(0, 2, 1);
    open.add_triangle(0, 1, 3);
    open.add_triangle(0, 3, 2);
    EXPECT_FALSE(open.finish("open", glm::vec3(0.5f), 0.0).closed);
    MeshBuilder whole = open;
    whole.add_triangle(1, 2, 3);
    EXPECT_TRUE(whole.finish("whole", glm::vec3(0.5f), 0.0).closed);
    MeshBuilder inverted;
    for (const glm::dvec3& point : open.points()) {
        inverted.add_point(point);
    }
    for (const auto& triangle : whole.triangles()) {
        inverted.add_triangle(triangle[0], triangle[2], triangle[1]);
    }
    EXPECT_FALSE(inverted.finish("inverted", glm::vec3(0.5f), 0.0).closed);
}

} // namespace
} // namespace alcove
