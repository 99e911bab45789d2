#include "scenes/cathedral/cathedral.hpp"

#include "core/base/error.hpp"
#include "tests/scenes/solid_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Scene> open(const std::string& detail, const std::string& seed = "1") {
    const SceneUnit unit = cathedral_unit();
    const std::vector<ParameterOverride> overrides{{"detail", detail}, {"seed", seed}};
    return unit.open(unit.parameters.resolve(overrides, {}));
}

/// A triangle in the world.
struct Triangle {
    std::size_t object = 0;
    std::array<glm::dvec3, 3> corners;
};

std::vector<Triangle> collect_triangles(const Scene& scene) {
    std::vector<Triangle> triangles;
    const Pose pose = scene.compute_pose(0.0);
    for (std::size_t o = 0; o < scene.get_objects().size(); ++o) {
        const Mesh& mesh = scene.get_meshes()[scene.get_objects()[o].mesh];
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            Triangle triangle{o, {}};
            for (std::size_t k = 0; k < 3; ++k) {
                triangle.corners[k] =
                    glm::dvec3(pose.object_to_world[o] *
                               glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1.0));
            }
            triangles.push_back(triangle);
        }
    }
    return triangles;
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

class CathedralDetail : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Range, CathedralDetail, testing::Values("0.125", "0.5", "1", "2.7", "8"),
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

TEST(Cathedral, IsDecidedByItsParametersAlone) {
    const std::string hash = hash_geometry(*open("1", "1"), 0.0);
    EXPECT_EQ(hash, hash_geometry(*open("1", "1"), 3.0));
    EXPECT_NE(hash, hash_geometry(*open("1", "2"), 0.0));
    EXPECT_NE(hash, hash_geometry(*open("1", "0"), 0.0));
    EXPECT_NE(hash, hash_geometry(*open("1.5", "1"), 0.0));
}

TEST(Cathedral, RejectsParametersOutOfRange) {
    EXPECT_THROW(static_cast<void>(open("9")), InputError);
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

TEST_P(CathedralDetail, NoTwoSolidsShareAFace) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    struct Face {
        Triangle triangle;
        glm::dvec3 normal;
        double offset = 0.0;
    };
    std::map<std::tuple<long, long, long>, std::vector<Face>> directions;
    for (const Triangle& triangle : collect_triangles(*scene)) {
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
        return scene->get_meshes()[scene->get_objects()[face.triangle.object].mesh].name;
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
    EXPECT_TRUE(shared.empty()) << names;
}

TEST_P(CathedralDetail, TheCameraStaysClearOfAllSolids) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    const std::vector<Triangle> triangles = collect_triangles(*scene);
    const std::vector<Camera>& cameras = scene->get_walkthrough().cameras;
    ASSERT_EQ(cameras.size(), 120u);
    // A corner of the near plane at 16:9 and 65 degrees is 1.7 times as far as the plane.
    const double clear = 2.0 * cameras.front().near_m;
    for (std::size_t frame = 0; frame < cameras.size(); frame += 3) {
        const glm::dvec3& eye = cameras[frame].position;
        double nearest = 1e30;
        std::map<std::size_t, double> angles;
        for (const Triangle& triangle : triangles) {
            nearest = std::min(nearest, distance_to_triangle(eye, triangle.corners));
            angles[triangle.object] += solid_angle(eye, triangle.corners);
        }
        EXPECT_GT(nearest, clear) << "frame " << frame;
        for (const auto& [object, angle] : angles) {
            EXPECT_LT(std::abs(angle), 1.0)
                << "frame " << frame << " inside " << scene->get_objects()[object].name;
        }
    }
}

TEST(Cathedral, HasTheSizeOfAChurch) {
    glm::dvec3 low(1e9);
    glm::dvec3 high(-1e9);
    for (const Triangle& triangle : collect_triangles(*open("1"))) {
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
