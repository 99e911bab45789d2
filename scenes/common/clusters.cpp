#include "scenes/common/clusters.hpp"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <meshoptimizer.h>

namespace alcove {
namespace {

/// A draw command costs llvmpipe about as much as 200 triangles.
constexpr std::size_t kMostTriangles = 256;
constexpr std::size_t kMostVertices = 255;
constexpr std::size_t kWorthCutting = 4 * kMostTriangles;
/// 0 cares for neighbourhood alone, 1 for equal facing alone; meshoptimizer's advice.
constexpr float kConeWeight = 0.25f;

} // namespace

void build_clusters(Mesh& mesh) {
    if (!mesh.clusters.empty() || mesh.indices.size() <= 3 * kWorthCutting) {
        return;
    }
    const float* positions = &mesh.positions.data()->x;
    const std::size_t count = mesh.positions.size();
    std::vector<meshopt_Meshlet> meshlets(
        meshopt_buildMeshletsBound(mesh.indices.size(), kMostVertices, kMostTriangles));
    std::vector<unsigned> vertices(meshlets.size() * kMostVertices);
    std::vector<unsigned char> corners(meshlets.size() * kMostTriangles * 3);
    meshlets.resize(meshopt_buildMeshlets(
        meshlets.data(), vertices.data(), corners.data(), mesh.indices.data(), mesh.indices.size(),
        positions, count, sizeof(glm::vec3), kMostVertices, kMostTriangles, kConeWeight));
    std::vector<std::uint32_t> sorted;
    sorted.reserve(mesh.indices.size());
    for (const meshopt_Meshlet& meshlet : meshlets) {
        Cluster cluster;
        cluster.first_index = static_cast<std::uint32_t>(sorted.size());
        cluster.index_count = 3 * meshlet.triangle_count;
        cluster.low = glm::vec3(std::numeric_limits<float>::infinity());
        cluster.high = -cluster.low;
        for (std::size_t i = 0; i < cluster.index_count; ++i) {
            const unsigned corner = corners[meshlet.triangle_offset + i];
            sorted.push_back(vertices[meshlet.vertex_offset + corner]);
            cluster.low = glm::min(cluster.low, mesh.positions[sorted.back()]);
            cluster.high = glm::max(cluster.high, mesh.positions[sorted.back()]);
        }
        const meshopt_Bounds bounds = meshopt_computeMeshletBounds(
            &vertices[meshlet.vertex_offset], &corners[meshlet.triangle_offset],
            meshlet.triangle_count, positions, count, sizeof(glm::vec3));
        cluster.cone_apex = {bounds.cone_apex[0], bounds.cone_apex[1], bounds.cone_apex[2]};
        cluster.cone_axis = {bounds.cone_axis[0], bounds.cone_axis[1], bounds.cone_axis[2]};
        cluster.cone_cutoff = bounds.cone_cutoff;
        mesh.clusters.push_back(cluster);
    }
    mesh.indices = std::move(sorted);
}

} // namespace alcove
