#include "scenes/common/mesh_builder.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// Corners of one point whose normals differ by less than this (1 - cosine) share a vertex.
constexpr double kSameNormal = 1e-9;

struct Face {
    glm::dvec3 normal{0.0};         ///< unit; zero for a face without area
    std::array<double, 3> angles{}; ///< radians, at each corner
};

Face measure_face(const std::vector<glm::dvec3>& points,
                  const std::array<std::uint32_t, 3>& triangle) {
    Face face;
    const glm::dvec3 cross = glm::cross(points[triangle[1]] - points[triangle[0]],
                                        points[triangle[2]] - points[triangle[0]]);
    const double length = glm::length(cross);
    if (!(length > 1e-14)) {
        return face;
    }
    face.normal = cross / length;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::dvec3& apex = points[triangle[corner]];
        const glm::dvec3 u = glm::normalize(points[triangle[(corner + 1) % 3]] - apex);
        const glm::dvec3 v = glm::normalize(points[triangle[(corner + 2) % 3]] - apex);
        face.angles[corner] = std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0));
    }
    return face;
}

/// A corner of a triangle at some point.
struct Corner {
    std::uint32_t triangle = 0;
    std::uint32_t place = 0; ///< 0, 1 or 2
};

glm::dvec3 average_normal(const std::vector<Corner>& fan, const std::vector<Face>& faces,
                          const Corner& corner, double minimum_cosine) {
    const glm::dvec3 own = faces[corner.triangle].normal;
    const bool has_area = own != glm::dvec3(0.0);
    glm::dvec3 sum(0.0);
    for (const Corner& other : fan) {
        const Face& face = faces[other.triangle];
        if (!has_area || glm::dot(face.normal, own) >= minimum_cosine) {
            sum += face.angles[other.place] * face.normal;
        }
    }
    if (glm::length(sum) > 1e-9) {
        return glm::normalize(sum);
    }
    return has_area ? own : glm::dvec3(0.0, 1.0, 0.0);
}

} // namespace

std::uint32_t MeshBuilder::add_point(const glm::dvec3& point) {
    m_points.push_back(point);
    return static_cast<std::uint32_t>(m_points.size() - 1);
}

void MeshBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    ALCOVE_ASSERT(std::max({a, b, c}) < m_points.size(), "a triangle of points that exist");
    if (a != b && b != c && c != a) {
        m_triangles.push_back({a, b, c});
    }
}

void MeshBuilder::add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    add_triangle(a, b, c);
    add_triangle(a, c, d);
}

bool MeshBuilder::is_closed() const {
    std::vector<std::uint64_t> edges;
    std::vector<std::uint64_t> opposite;
    edges.reserve(3 * m_triangles.size());
    opposite.reserve(3 * m_triangles.size());
    double volume = 0.0;
    const auto join = [](std::uint64_t from, std::uint64_t to) { return from << 32u | to; };
    for (const std::array<std::uint32_t, 3>& triangle : m_triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            edges.push_back(join(triangle[i], triangle[(i + 1) % 3]));
            opposite.push_back(join(triangle[(i + 1) % 3], triangle[i]));
        }
        volume += glm::dot(m_points[triangle[0]],
                           glm::cross(m_points[triangle[1]], m_points[triangle[2]]));
    }
    std::sort(edges.begin(), edges.end());
    std::sort(opposite.begin(), opposite.end());
    const bool is_manifold = std::adjacent_find(edges.begin(), edges.end()) == edges.end();
    return is_manifold && edges == opposite && volume > 0.0;
}

Mesh MeshBuilder::finish(std::string name, const glm::vec3& albedo, double crease_degrees) const {
    ALCOVE_ASSERT(!m_triangles.empty(), "a mesh has triangles");
    ALCOVE_ASSERT(crease_degrees >= 0.0 && crease_degrees <= 180.0, "a crease angle in degrees");
    // The slack makes 180 mean all faces and 0 mean faces of one plane, whatever the last bit.
    const double minimum_cosine = std::cos(crease_degrees * std::numbers::pi / 180.0) - 1e-9;
    std::vector<Face> faces;
    faces.reserve(m_triangles.size());
    std::vector<std::vector<Corner>> fans(m_points.size());
    for (std::uint32_t t = 0; t < m_triangles.size(); ++t) {
        faces.push_back(measure_face(m_points, m_triangles[t]));
        for (std::uint32_t place = 0; place < 3; ++place) {
            fans[m_triangles[t][place]].push_back({t, place});
        }
    }

    Mesh mesh;
    mesh.name = std::move(name);
    mesh.albedo = albedo;
    mesh.closed = is_closed();
    mesh.indices.resize(m_triangles.size() * 3);
    for (std::size_t point = 0; point < m_points.size(); ++point) {
        std::vector<std::pair<glm::dvec3, std::uint32_t>> made;
        for (const Corner& corner : fans[point]) {
            const glm::dvec3 normal = average_normal(fans[point], faces, corner, minimum_cosine);
            const auto same = std::find_if(made.begin(), made.end(), [&normal](const auto& entry) {
                return glm::dot(entry.first, normal) > 1.0 - kSameNormal;
            });
            std::uint32_t vertex = 0;
            if (same != made.end()) {
                vertex = same->second;
            } else {
                vertex = static_cast<std::uint32_t>(mesh.positions.size());
                mesh.positions.emplace_back(m_points[point]);
                mesh.normals.emplace_back(normal);
                made.emplace_back(normal, vertex);
            }
            mesh.indices[std::size_t{corner.triangle} * 3 + corner.place] = vertex;
        }
    }
    return mesh;
}

} // namespace alcove
