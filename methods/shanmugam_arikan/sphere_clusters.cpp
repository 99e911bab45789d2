#include "methods/shanmugam_arikan/sphere_clusters.hpp"

#include "core/base/assert.hpp"
#include "methods/common/sequence.hpp"
#include "methods/shanmugam_arikan/lloyd.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

constexpr int kLloydIterations = 8;

struct Triangle {
    std::array<glm::vec3, 3> corners;
};

Triangle get_triangle(std::span<const glm::vec3> positions, const Mesh& mesh, std::size_t first) {
    return {{positions[mesh.indices[first]], positions[mesh.indices[first + 1]],
             positions[mesh.indices[first + 2]]}};
}

glm::vec3 place_member(std::span<const glm::vec3> positions, const Mesh& mesh,
                       const ClusterMember& member) {
    const Triangle triangle = get_triangle(positions, mesh, member.triangle);
    return triangle.corners[0] + member.u * (triangle.corners[1] - triangle.corners[0]) +
           member.v * (triangle.corners[2] - triangle.corners[0]);
}

/// Areas of an object's triangles in the pose, summed up to each.
std::vector<double> accumulate_areas(const PosedObject& object) {
    const glm::mat3 linear(object.origin_from_object);
    std::vector<double> sums;
    double sum = 0.0;
    for (std::size_t i = 0; i + 2 < object.mesh->indices.size(); i += 3) {
        const Triangle t = get_triangle(object.positions(), *object.mesh, i);
        const glm::vec3 normal = glm::cross(linear * (t.corners[1] - t.corners[0]),
                                            linear * (t.corners[2] - t.corners[0]));
        sum += 0.5 * static_cast<double>(glm::length(normal));
        sums.push_back(sum);
    }
    return sums;
}

/// `count` points, evenly spread over the area in the order of the triangles; within a triangle by
/// the bases 2 and 3 of a Halton sequence.
std::vector<ClusterMember> spread_members(const std::vector<double>& areas, std::size_t count) {
    std::vector<ClusterMember> members;
    for (std::size_t i = 0; i < count; ++i) {
        const double at =
            (static_cast<double>(i) + 0.5) / static_cast<double>(count) * areas.back();
        const auto found = std::lower_bound(areas.begin(), areas.end(), at);
        const auto triangle = static_cast<std::uint32_t>(std::min<std::ptrdiff_t>(
            found - areas.begin(), static_cast<std::ptrdiff_t>(areas.size()) - 1));
        const auto index = static_cast<std::uint32_t>(i + 1);
        double u = compute_radical_inverse(index, 2);
        double v = compute_radical_inverse(index, 3);
        if (u + v > 1.0) { // the other half of the parallelogram
            u = 1.0 - u;
            v = 1.0 - v;
        }
        members.push_back({3 * triangle, static_cast<float>(u), static_cast<float>(v)});
    }
    return members;
}

/// Every vertex that a triangle uses, once.
std::vector<ClusterMember> list_vertices(const Mesh& mesh) {
    std::vector<ClusterMember> members;
    std::vector<bool> is_listed(mesh.positions.size(), false);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (is_listed[mesh.indices[i]]) {
            continue;
        }
        is_listed[mesh.indices[i]] = true;
        const auto triangle = static_cast<std::uint32_t>(i - i % 3);
        members.push_back({triangle, i % 3 == 1 ? 1.0f : 0.0f, i % 3 == 2 ? 1.0f : 0.0f});
    }
    return members;
}

void add_object(const PosedObject& object, std::uint32_t index, std::size_t spheres,
                std::vector<ClusterMember> members, ClusterSet& set) {
    std::vector<glm::vec3> places;
    for (const ClusterMember& member : members) {
        places.emplace_back(
            object.origin_from_object *
            glm::vec4(place_member(object.positions(), *object.mesh, member), 1.0f));
    }
    const std::size_t count = std::min(spheres, members.size());
    const std::vector<std::uint32_t> owners = cluster_points(places, count, kLloydIterations);
    std::vector<std::size_t> order(members.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return owners[a] < owners[b]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || owners[order[i]] != owners[order[i - 1]]) {
            set.clusters.push_back({index, static_cast<std::uint32_t>(set.members.size()), 0});
        }
        ++set.clusters.back().count;
        set.members.push_back(members[order[i]]);
    }
}

float compute_radius(RadiusRule rule, double mean_square, double largest_square) {
    switch (rule) {
    case RadiusRule::covering:
        return static_cast<float>(std::sqrt(largest_square));
    case RadiusRule::rms_ball: // a solid ball of radius r has the mean square 3/5 r^2
        return static_cast<float>(std::sqrt(mean_square * 5.0 / 3.0));
    case RadiusRule::silhouette: // half of the disc's: a quarter of its area
        return static_cast<float>(std::sqrt(mean_square * 0.5));
    case RadiusRule::rms_disc: // a disc: 1/2 r^2
        break;
    }
    return static_cast<float>(std::sqrt(mean_square * 2.0));
}

/// Mean of the unit normals of the members' triangles: 1 long in a plane, 0 all around a solid.
glm::dvec3 compute_mean_normal(std::span<const glm::vec3> positions, const Mesh& mesh,
                               std::span<const ClusterMember> members) {
    glm::dvec3 sum(0.0);
    for (const ClusterMember& member : members) {
        const Triangle t = get_triangle(positions, mesh, member.triangle);
        const glm::dvec3 normal = glm::cross(glm::dvec3(t.corners[1] - t.corners[0]),
                                             glm::dvec3(t.corners[2] - t.corners[0]));
        const double length = glm::length(normal);
        sum += length > 0.0 ? normal / length : glm::dvec3(0.0);
    }
    return sum / static_cast<double>(members.size());
}

Sphere fit_sphere(std::span<const glm::vec3> positions, const Mesh& mesh,
                  std::span<const ClusterMember> members, RadiusRule rule, double push_back) {
    glm::dvec3 sum(0.0);
    for (const ClusterMember& member : members) {
        sum += glm::dvec3(place_member(positions, mesh, member));
    }
    const glm::dvec3 center = sum / static_cast<double>(members.size());
    double squares = 0.0;
    double largest = 0.0;
    for (const ClusterMember& member : members) {
        const glm::dvec3 off = glm::dvec3(place_member(positions, mesh, member)) - center;
        squares += glm::dot(off, off);
        largest = std::max(largest, glm::dot(off, off));
    }
    const float radius =
        compute_radius(rule, squares / static_cast<double>(members.size()), largest);
    const glm::dvec3 pushed = center - push_back * static_cast<double>(radius) *
                                           compute_mean_normal(positions, mesh, members);
    return {glm::vec3(pushed), radius};
}

} // namespace

ClusterSet find_clusters(const PosedGeometry& rest, const ClusterSettings& settings) {
    ALCOVE_ASSERT(settings.spheres > 0, "a number of spheres");
    std::vector<std::vector<double>> areas;
    double total = 0.0;
    for (const PosedObject& object : rest.objects) {
        areas.push_back(accumulate_areas(object));
        total += areas.back().empty() ? 0.0 : areas.back().back();
    }
    ClusterSet set;
    for (std::size_t i = 0; i < rest.objects.size(); ++i) {
        const double area = areas[i].empty() ? 0.0 : areas[i].back();
        const auto spheres = static_cast<std::size_t>(std::lround(settings.spheres * area / total));
        if (area <= 0.0 || spheres == 0) {
            continue;
        }
        std::vector<ClusterMember> members =
            settings.members == SphereMembers::vertices
                ? list_vertices(*rest.objects[i].mesh)
                : spread_members(areas[i], spheres * kMembersPerSphere);
        add_object(rest.objects[i], static_cast<std::uint32_t>(i), spheres, std::move(members),
                   set);
    }
    return set;
}

std::vector<Sphere> SpherePoser::pose(const PosedGeometry& geometry) {
    const bool is_first = m_local.empty();
    m_local.resize(m_clusters.clusters.size());
    std::vector<Sphere> spheres;
    for (std::size_t i = 0; i < m_clusters.clusters.size(); ++i) {
        const SphereCluster& cluster = m_clusters.clusters[i];
        const PosedObject& object = geometry.objects[cluster.object];
        if (is_first || object.deformation) {
            m_local[i] =
                fit_sphere(object.positions(), *object.mesh,
                           std::span(m_clusters.members).subspan(cluster.first, cluster.count),
                           m_rule, m_push_back);
        }
        const float volume = std::abs(glm::determinant(glm::mat3(object.origin_from_object)));
        spheres.push_back(
            {glm::vec3(object.origin_from_object * glm::vec4(m_local[i].center, 1.0f)),
             m_local[i].radius * std::cbrt(volume)});
    }
    return spheres;
}

} // namespace alcove
