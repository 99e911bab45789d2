#include "tests/scenes/space_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace alcove {
namespace {

void append_triangles(const Scene& scene, const Pose& pose, std::size_t object,
                      std::vector<Triangle>& triangles) {
    const Mesh& mesh = scene.get_meshes()[scene.get_objects()[object].mesh];
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        Triangle triangle{object, {}};
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.corners[k] =
                glm::dvec3(pose.object_to_world[object] *
                           glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1.0));
        }
        triangles.push_back(triangle);
    }
}

/// C. Ericson. Real-Time Collision Detection. 2005, section 5.1.5, by regions.
double distance_to_triangle(const glm::dvec3& p, const std::array<glm::dvec3, 3>& t) {
    const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    bool inside = glm::length(normal) > 1e-12;
    double nearest = 1e30;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 a = t[k];
        const glm::dvec3 edge = t[(k + 1) % 3] - a;
        inside = inside && glm::dot(glm::cross(edge, p - a), normal) >= 0.0;
        const double length2 = glm::dot(edge, edge);
        const double s =
            length2 > 0.0 ? glm::clamp(glm::dot(p - a, edge) / length2, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, glm::distance(p, a + s * edge));
    }
    return inside ? std::abs(glm::dot(p - t[0], glm::normalize(normal))) : nearest;
}

/// Solid angle of a triangle seen from p (A. Van Oosterom, J. Strackee. 1983): over a closed solid
/// they sum up to 4 pi inside and to 0 outside.
double solid_angle(const glm::dvec3& p, const std::array<glm::dvec3, 3>& t) {
    const glm::dvec3 a = t[0] - p;
    const glm::dvec3 b = t[1] - p;
    const glm::dvec3 c = t[2] - p;
    const double la = glm::length(a);
    const double lb = glm::length(b);
    const double lc = glm::length(c);
    return 2.0 *
           std::atan2(glm::dot(a, glm::cross(b, c)), la * lb * lc + glm::dot(a, b) * lc +
                                                         glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

/// Two triangles of one plane overlap if no edge of either separates them, by a tenth of a
/// millimetre.
bool overlap_in_plane(const Triangle& s, const Triangle& t, const glm::dvec3& normal) {
    for (const Triangle* side : {&s, &t}) {
        const Triangle& other = side == &s ? t : s;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 edge = side->corners[(k + 1) % 3] - side->corners[k];
            const glm::dvec3 outward = glm::normalize(glm::cross(edge, normal));
            double nearest = 1e30;
            for (const glm::dvec3& corner : other.corners) {
                nearest = std::min(nearest, glm::dot(corner - side->corners[k], outward));
            }
            if (nearest > -1e-4) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

std::vector<Triangle> collect_triangles(const Scene& scene, const Pose& pose) {
    std::vector<Triangle> triangles;
    for (std::size_t object = 0; object < scene.get_objects().size(); ++object) {
        append_triangles(scene, pose, object, triangles);
    }
    return triangles;
}

std::vector<Triangle> collect_triangles_near(const Scene& scene, const Pose& pose,
                                             const glm::dvec3& point, double reach_m) {
    struct Box {
        glm::dvec3 low{1e30};
        glm::dvec3 high{-1e30};
    };
    std::vector<Box> boxes;
    for (const Mesh& mesh : scene.get_meshes()) {
        Box box;
        for (const glm::vec3& position : mesh.positions) {
            box.low = glm::min(box.low, glm::dvec3(position));
            box.high = glm::max(box.high, glm::dvec3(position));
        }
        boxes.push_back(box);
    }
    std::vector<Triangle> triangles;
    for (std::size_t object = 0; object < scene.get_objects().size(); ++object) {
        // The point in the object's space; transforms keep angles.
        const glm::dmat4& transform = pose.object_to_world[object];
        const double scale = glm::length(glm::dvec3(transform[0]));
        const glm::dvec3 away = point - glm::dvec3(transform[3]);
        glm::dvec3 local(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            local[axis] = glm::dot(glm::dvec3(transform[axis]), away) / (scale * scale);
        }
        const Box& box = boxes[scene.get_objects()[object].mesh];
        if (scale * glm::distance(local, glm::clamp(local, box.low, box.high)) < reach_m) {
            append_triangles(scene, pose, object, triangles);
        }
    }
    return triangles;
}

Clearance measure_clearance(const std::vector<Triangle>& triangles, const glm::dvec3& point) {
    Clearance clearance;
    std::map<std::size_t, double> angles;
    for (const Triangle& triangle : triangles) {
        clearance.distance_m =
            std::min(clearance.distance_m, distance_to_triangle(point, triangle.corners));
        angles[triangle.object] += solid_angle(point, triangle.corners);
    }
    for (const auto& [object, angle] : angles) {
        if (std::abs(angle) > std::numbers::pi) { // inside it is 4 pi, outside 0
            clearance.inside = object;
        }
    }
    return clearance;
}

std::string list_shared_faces(const Scene& scene, const std::vector<Triangle>& triangles) {
    struct Face {
        Triangle triangle;
        glm::dvec3 normal;
        double offset = 0.0;
    };
    std::map<std::tuple<long, long, long>, std::vector<Face>> directions;
    for (const Triangle& triangle : triangles) {
        const auto& t = triangle.corners;
        const glm::dvec3 cross = glm::cross(t[1] - t[0], t[2] - t[0]);
        if (glm::length(cross) < 1e-6) {
            continue;
        }
        const glm::dvec3 normal = glm::normalize(cross);
        directions[{std::lround(normal.x * 1e3), std::lround(normal.y * 1e3),
                    std::lround(normal.z * 1e3)}]
            .push_back({triangle, normal, glm::dot(normal, t[0])});
    }
    const auto name_mesh = [&scene](const Face& face) {
        return scene.get_meshes()[scene.get_objects()[face.triangle.object].mesh].name;
    };
    std::set<std::string> shared; // pairs of meshes
    for (auto& [direction, faces] : directions) {
        std::sort(faces.begin(), faces.end(),
                  [](const Face& a, const Face& b) { return a.offset < b.offset; });
        for (std::size_t i = 0; i < faces.size(); ++i) {
            for (std::size_t j = i + 1;
                 j < faces.size() && faces[j].offset - faces[i].offset < 2e-4; ++j) {
                const Face& a = faces[i];
                const Face& b = faces[j];
                if (a.triangle.object != b.triangle.object &&
                    overlap_in_plane(a.triangle, b.triangle, a.normal)) {
                    shared.insert(name_mesh(a) + " and " + name_mesh(b));
                }
            }
        }
    }
    std::string names;
    for (const std::string& pair : shared) {
        names += pair + "\n";
    }
    return names;
}

} // namespace alcove
